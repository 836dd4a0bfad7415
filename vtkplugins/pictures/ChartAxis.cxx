#include "vtkplugins/pictures/ChartAxis.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kPadding = 0.05;  // of the range, at each end

double largestMagnitude(std::span<const double> values) {
    double largest = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            largest = std::max(largest, std::abs(value));
        }
    }
    return largest;
}

}  // namespace

ChartAxis::ChartAxis(const Request& request, std::span<const double> values)
    : logarithmic_(request.logarithmic), title_(request.label) {
    if (!request.unit.empty()) {
        const SiScale scale = siScaleFor(largestMagnitude(values), request.unit);
        factor_ = scale.factor;
        title_ += " [" + scale.unit + "]";
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        const double at = place(value);
        if (std::isfinite(at)) {
            low = std::min(low, at);
            high = std::max(high, at);
        }
    }
    if (low > high) {  // nothing to show
        low = 0.0;
        high = 1.0;
    }
    const double span = high - low;
    const double least = 1e-9 * std::max(std::abs(low), std::abs(high));
    const double padding = span > least ? kPadding * span : low != 0.0 ? 0.5 * std::abs(low) : 1.0;
    low_ = low - padding;
    high_ = high + padding;
    if (!request.names.empty()) {
        setNames(request.names);
    } else if (logarithmic_) {
        setDecades(request.mostTicks);
    } else {
        setLinearTicks(request.mostTicks);
    }
}

double ChartAxis::place(double value) const {
    const double shown = value * factor_;
    if (!logarithmic_) {
        return shown;
    }
    return shown > 0.0 ? std::log10(shown) : std::numeric_limits<double>::quiet_NaN();
}

void ChartAxis::setNames(const std::vector<std::string>& names) {
    low_ = -0.5;
    high_ = static_cast<double>(names.size()) - 0.5;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ticks_.push_back(static_cast<double>(i));
    }
    labels_ = names;
}

void ChartAxis::setLinearTicks(int most) {
    ticks_ = niceTicks(low_, high_, most);
    labels_ = tickLabels(ticks_);
}

void ChartAxis::setDecades(int most) {
    const bool withinFewDecades = high_ - low_ < 2.0;
    const int decades = static_cast<int>(std::floor(high_) - std::ceil(low_)) + 1;
    const int step = std::max(1, (decades + most - 1) / most);
    for (int power = static_cast<int>(std::floor(low_)); power <= high_; power += step) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double at = power + std::log10(digit);
            if ((digit == 1.0 || withinFewDecades) && at >= low_ && at <= high_) {
                ticks_.push_back(at);
                labels_.push_back(formatted("%g", digit * std::pow(10.0, power)));
            }
        }
    }
}

}  // namespace asperity
