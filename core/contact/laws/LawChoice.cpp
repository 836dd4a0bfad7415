#include "core/contact/laws/LawChoice.h"

#include "core/contact/ContactStatus.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/contact/laws/MaugisLaw.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisUnits.h"

namespace asperity {

namespace {

constexpr double kLargeContact = 0.3;  // a/R beyond which the paraboloid errs by some 3 %

/// Contact radius over tip radius without load, by Maugis-Dugdale on the paraboloid.
double unloadedRatio(const ContactPair& pair) {
    const MaugisUnits units = maugisUnits(pair);
    const MaugisLaw law(pair, pair.workOfAdhesion / kCohesiveRange);
    const auto point = MaugisDugdale(law.lambda()).stable(MaugisControl::load(), 0.0);
    return point ? point->contactRadius * units.radius / pair.tipRadius : 0.0;
}

}  // namespace

bool isLargeContact(double contactRadius, double effectiveRadius) noexcept {
    return contactRadius > kLargeContact * effectiveRadius;
}

LawChoice chooseLaw(std::optional<ContactLaw> wanted, const ContactPair& pair, double filmThickness,
                    double coneHalfAngle) {
    if (wanted) {
        return {.law = *wanted, .reason = LawReason::AskedFor};
    }
    requirePair(pair, pair.workOfAdhesion);  // any stress will do to look at the pair
    if (pair.workOfAdhesion < kMinAdhesion) {
        if (filmThickness > 0.0) {
            return {ContactLaw::HertzFilm, LawReason::FilmWithoutAdhesion};
        }
        return coneHalfAngle > 0.0 ? LawChoice{ContactLaw::Sneddon, LawReason::NoAdhesionCone}
                                   : LawChoice{ContactLaw::Hertz, LawReason::NoAdhesion};
    }
    const double ratio = unloadedRatio(pair);
    return ratio > kLargeContact ? LawChoice{ContactLaw::SphereSplit, LawReason::WideContact, ratio}
                                 : LawChoice{ContactLaw::Split, LawReason::NarrowContact, ratio};
}

}  // namespace asperity
