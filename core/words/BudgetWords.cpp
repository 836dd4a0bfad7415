#include "core/words/BudgetWords.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"

#include <cmath>
#include <vector>

namespace asperity {

namespace {

const char* const kLeftOut = "terms left out";

/// To one digit, to two where that is a 1: more is not known of a deviation.
std::string digitsOf(double deviation) {
    const double power = std::pow(10.0, std::floor(std::log10(deviation)));
    const double step = deviation < 2.0 * power ? 0.1 * power : power;
    return formatted("%.4g", std::round(deviation / step) * step);
}

std::string partText(double deviation, double factor, const std::string& inputs) {
    return deviation > 0.0 && std::isfinite(deviation)
               ? " ± " + digitsOf(deviation * factor) + " (" + inputs + ")"
               : std::string();
}

/// Names the shift where it would move the 95 % interval by more than a twentieth of its
/// half-width.
std::string shiftText(const Budget& budget, double factor) {
    constexpr double kSeen = 0.1;  // standard deviations
    const double shift = std::abs(budget.shift);
    if (!(shift > kSeen * budget.total())) {
        return {};
    }
    return (budget.shift > 0.0 ? ", too high by " : ", too low by ") + digitsOf(shift * factor) +
           " (imaging tip)";
}

/// Names what is left out where it raises the deviation of the model by more than a twentieth.
std::string leftOutText(const Budget& budget, double factor) {
    constexpr double kSeen = 0.32;  // of the inputs' deviation
    const double inputs = std::isfinite(budget.inputs()) ? budget.inputs() : 0.0;
    return budget.leftOut > kSeen * inputs ? partText(budget.leftOut, factor, kLeftOut)
                                           : std::string();
}

/// Returns what is unknown where the shares are.
const char* unknownParts(const Budget& budget) {
    return budget.isLeftOutKnown() ? "calibration, tip and material" : "model and calibration";
}

/// A part that is not known must not look like one that is 0.
std::string unknownPartText(const Budget& budget) {
    if (budget.unknown == UnknownShares::None) {
        return budget.isLeftOutKnown() ? std::string() : " ± ? (" + std::string(kLeftOut) + ")";
    }
    return " ± ? (" + std::string(unknownParts(budget)) + ": " + nameOf(budget.unknown) + ")";
}

std::string inputList(const Budget& budget) {
    constexpr std::size_t kMax = 4;
    std::string list;
    std::size_t count = 0;
    for (const UncertaintyInput input : budget.mainInputs()) {
        list += (list.empty() ? "" : ", ") + std::string(nameOf(input));
        if (++count == kMax) {
            break;
        }
    }
    return list;
}

}  // namespace

std::string budgetText(const Budget& budget, const char* unit) {
    const SiScale scale = siScaleFor(budget.value, unit);
    return formatSi(budget.value, unit) + partText(budget.noise, scale.factor, "noise") +
           partText(budget.inputs(), scale.factor, inputList(budget)) +
           leftOutText(budget, scale.factor) + unknownPartText(budget) +
           shiftText(budget, scale.factor);
}

std::string mostBy(const Budget& budget) {
    if (budget.isMostLeftOut()) {
        return kLeftOut;
    }
    if (budget.unknown != UnknownShares::None) {
        return "not known";
    }
    const std::optional<UncertaintyInput> dominant = budget.dominant();
    return dominant ? nameOf(*dominant) : "–";
}

std::string unknownText(const Budget& budget, const char* name) {
    if (budget.unknown != UnknownShares::None) {
        return formatted("the uncertainty of the %s from %s is not known: %s", name,
                         unknownParts(budget), nameOf(budget.unknown));
    }
    return budget.isLeftOutKnown()
               ? std::string()
               : formatted("the effect of the terms left out on the %s is not known", name);
}

std::string resolutionText(const Budget& budget, const char* name, double tolerance) {
    const double share = budget.resolutionShare();
    const double hidden = budget.value != 0.0 ? budget.hidden / std::abs(budget.value) : 0.0;
    if (share > tolerance && !(hidden > share)) {
        return formatted("smoothing and pixels move the %s by %.2g %%, more than the tolerance of "
                         "%.2g %%",
                         name, 100.0 * share, 100.0 * tolerance);
    }
    if (hidden > tolerance) {
        return formatted("noise of the heights hides roughness that may move the %s by %.2g %%; "
                         "the stated deviations do not include it",
                         name, 100.0 * hidden);
    }
    return {};
}

}  // namespace asperity
