#include "core/uncertainty/Budget.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asperity {

double Budget::inputs() const noexcept {
    return std::sqrt(std::inner_product(shares.begin(), shares.end(), shares.begin(), 0.0));
}

double Budget::model() const noexcept { return std::hypot(inputs(), leftOut); }

bool Budget::isModelKnown() const noexcept { return std::isfinite(model()); }

bool Budget::isLeftOutKnown() const noexcept { return isLeftOutJudged && std::isfinite(leftOut); }

double Budget::modelAboutValue() const noexcept { return std::hypot(model(), shift); }

double Budget::total() const noexcept { return std::hypot(noise, model()); }

std::optional<UncertaintyInput> Budget::dominant() const noexcept {
    const auto largest = std::ranges::max_element(shares);
    return std::isfinite(inputs()) && *largest > 0.0
               ? std::optional(static_cast<UncertaintyInput>(largest - shares.begin()))
               : std::nullopt;
}

bool Budget::isMostLeftOut() const noexcept {
    return isModelKnown() && leftOut > *std::ranges::max_element(shares);
}

std::vector<UncertaintyInput> Budget::mainInputs() const {
    constexpr double kMain = 0.9;
    if (!std::isfinite(this->inputs())) {
        return {};
    }
    std::vector<UncertaintyInput> inputs(kValues<UncertaintyInput>.begin(),
                                         kValues<UncertaintyInput>.end());
    std::ranges::stable_sort(inputs, std::greater(), [this](auto input) { return share(input); });
    const double all = this->inputs() * this->inputs();
    double sum = 0.0;
    std::size_t count = 0;
    while (count < inputs.size() && sum < kMain * all) {
        sum += share(inputs[count]) * share(inputs[count]);
        ++count;
    }
    inputs.resize(count);
    return inputs;
}

double Budget::resolutionShare() const noexcept {
    const double moved =
        std::hypot(share(UncertaintyInput::Smoothing), share(UncertaintyInput::Pixels));
    return value != 0.0 ? moved / std::abs(value) : 0.0;
}

Budget Budget::of(double reading, double deviation) const noexcept {
    if (!std::isfinite(value) || (value == 0.0 && reading != 0.0)) {
        return budgetByNoise(reading, deviation, UnknownShares::NoLandmark);
    }
    Budget budget = *this;
    const double scale = value != 0.0 ? std::abs(reading / value) : 0.0;
    budget.value = reading;
    budget.noise = deviation;
    budget.shift *= scale;
    budget.leftOut *= scale;
    budget.hidden *= scale;
    for (double& one : budget.shares) {
        one *= scale;
    }
    return budget;
}

Budget Budget::withoutShares(UnknownShares why) const noexcept {
    Budget budget = *this;
    budget.shares.fill(std::numeric_limits<double>::quiet_NaN());
    budget.unknown = why;
    budget.shift = 0.0;
    budget.hidden = 0.0;
    return budget;
}

Budget budgetByNoise(double value, double noise, UnknownShares why) noexcept {
    return Budget{.value = value, .noise = noise, .isLeftOutJudged = false}.withoutShares(why);
}

}  // namespace asperity
