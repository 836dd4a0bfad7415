#include "core/deformation/RimRounding.h"

#include "core/SmoothStep.h"

namespace asperity {

namespace {

constexpr double kRounding = 0.15;  // of the contact radius
constexpr double kSharpFrom = 0.4;  // of the tip radius: contact radius from which the rim is sharp
constexpr double kFullFrom = 0.9;   // of the tip radius: from here on it is rounded in full

}  // namespace

double rimRounding(const ContactState& contact, double tipRadius) noexcept {
    const double ratio = contact.contactRadius / tipRadius;
    return kRounding * contact.contactRadius *
           smoothStep((ratio - kSharpFrom) / (kFullFrom - kSharpFrom));
}

}  // namespace asperity
