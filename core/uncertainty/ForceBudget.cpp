#include "core/uncertainty/ForceBudget.h"

#include <algorithm>
#include <cmath>

namespace asperity {

double ownStiffnessDeviation(const Uncertainty& given) noexcept {
    const double common = given.thermalStiffness ? 2.0 * given.invOls : 0.0;
    return std::sqrt(std::max(0.0, (given.stiffness * given.stiffness) - (common * common)));
}

Budget forceBudget(const Uncertainty& given, double force, double noise) noexcept {
    Budget budget{.value = force, .noise = noise};
    if (given.enabled) {
        const auto set = [&](UncertaintyInput input, double deviation) {
            budget.shares[static_cast<std::size_t>(input)] = std::abs(force) * deviation;
        };
        set(UncertaintyInput::Stiffness, ownStiffnessDeviation(given));
        set(UncertaintyInput::InvOls, given.invOls);
    }
    return budget;
}

}  // namespace asperity
