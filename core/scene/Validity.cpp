#include "core/scene/Validity.h"

namespace asperity {

const char* validityName(Validity flag) noexcept {
    switch (flag) {
    case Validity::LargeContact:
        return "large_contact";
    case Validity::OutsideScan:
        return "outside_scan";
    case Validity::FilledPixel:
        return "filled_pixel";
    case Validity::FootNotFound:
        return "foot_not_found";
    case Validity::NotInEquilibrium:
        return "not_in_equilibrium";
    case Validity::FrictionLock:
        return "friction_lock";
    case Validity::ModelContradicted:
        return "model_contradicted";
    case Validity::CurvedSample:
        return "curved_sample";
    case Validity::SharpValley:
        return "sharp_valley";
    case Validity::SeveralFeet:
        return "several_feet";
    case Validity::TipNotHeld:
        return "tip_not_held";
    case Validity::ElasticLimit:
        return "elastic_limit";
    case Validity::ThinFilm:
        return "thin_film";
    case Validity::Implausible:
        return "implausible_estimate";
    case Validity::SnapInAhead:
        return "snap_in_ahead";
    case Validity::UncertainPixel:
        return "uncertain_pixel";
    case Validity::FeetUnproven:
        return "feet_unproven";
    case Validity::SingularGeometry:
        return "singular_geometry";
    case Validity::LawOutOfRange:
        return "law_out_of_range";
    case Validity::EstimateInconsistent:
        return "estimate_inconsistent";
    }
    return "unknown";
}

std::string validityText(ValidityFlags flags) {
    std::string text;
    for (int i = 0; i < kValidityFlagCount; ++i) {
        const auto flag = static_cast<Validity>(1U << static_cast<unsigned>(i));
        if (!flags.has(flag)) {
            continue;
        }
        if (!text.empty()) {
            text += '|';
        }
        text += validityName(flag);
    }
    return text.empty() ? "-" : text;
}

}  // namespace asperity
