#pragma once

#include "core/contact/ContactState.h"

#include <cmath>

namespace asperity {

/// The rim of a contact about as wide as the tip, or wider, is so sharp that the samples of a
/// picture make teeth of it: over how wide a stretch to either side the displacement is averaged
/// where it is drawn [m]. 0 for narrower contacts, which are drawn exactly.
[[nodiscard]] double rimRounding(const ContactState& contact, double tipRadius) noexcept;

/// A function of the distance from the axis, averaged over a stretch to either side.
template <class Function>
double averagedOverRim(const Function& function, double distance, double stretch) {
    if (stretch == 0.0) {
        return function(distance);
    }
    constexpr int kSteps = 8;
    double sum = 0.0;
    for (int step = 1 - kSteps; step < kSteps; ++step) {
        const double place = std::abs(distance + stretch * step / (kSteps - 1));
        sum += (kSteps - std::abs(step)) * function(place);
    }
    return sum / (kSteps * kSteps);
}

}  // namespace asperity
