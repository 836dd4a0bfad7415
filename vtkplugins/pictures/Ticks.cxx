#include "vtkplugins/pictures/Ticks.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>

namespace asperity {

double niceBelow(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double digit = value / power * (1.0 + 1e-9);
    return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

std::vector<double> niceTicks(double low, double high, int count) {
    const double least = (high - low) / count;
    if (!(least > 0.0) || !std::isfinite(least)) {
        return {low};
    }
    double step = niceBelow(least);
    if (step < least * (1.0 - 1e-9)) {
        step = niceBelow(2.5 * step);
    }
    std::vector<double> ticks;
    const double slack = 1e-9 * (high - low);
    const double first = std::ceil((low - slack) / step);
    const int last = static_cast<int>(std::floor((high + slack) / step - first));
    for (int n = 0; n <= last; ++n) {
        const double position = first + n;
        ticks.push_back(position == 0.0 ? 0.0 : position * step);
    }
    return ticks;
}

std::vector<std::string> tickLabels(const std::vector<double>& ticks) {
    const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 0.0;
    const double largest =
        ticks.empty() ? 0.0 : std::max(std::abs(ticks.front()), std::abs(ticks.back()));
    const bool plain = step > 0.0 && step >= 1e-4 && largest < 1e6;
    const int decimals =
        plain ? std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9))) : 0;
    std::vector<std::string> labels;
    for (const double tick : ticks) {
        labels.push_back(plain ? formatted("%.*f", decimals, tick) : formatted("%.6g", tick));
    }
    return labels;
}

}  // namespace asperity
