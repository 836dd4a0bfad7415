#include "core/studies/extremes/ContactDefect.h"

#include "core/contact/laws/HertzLaw.h"

#include <cmath>

namespace asperity {

const char* defectOf(const ContactState& state, const ContactSetting& setting,
                     double approach) noexcept {
    constexpr double kRounding = 1e-9;
    for (const double value : {state.force, state.indentation, state.contactRadius,
                               state.cohesiveRadius, state.stiffness, state.energyLost}) {
        if (!std::isfinite(value)) {
            return "a value is not finite";
        }
    }
    if (state.contactRadius < 0.0 || state.energyLost < 0.0 ||
        state.cohesiveRadius < state.contactRadius * (1.0 - kRounding)) {
        return "a radius or an energy is impossible";
    }
    // Indentation and force are Hertz' less what adhesion takes: that is how large rounding sees
    // them.
    const LawPoint hertz = HertzLaw(setting.pair).atContactRadius(state.contactRadius);
    const double compliance = setting.compliance();
    const double bent = compliance * state.force;
    const double size = std::abs(state.indentation) + std::abs(bent) + std::abs(approach) +
                        hertz.indentation + (compliance * hertz.force);
    const bool balanced = std::abs(state.indentation + bent - approach) <= kRounding * size;
    return balanced ? nullptr : "lever and sample are not in balance";
}

}  // namespace asperity
