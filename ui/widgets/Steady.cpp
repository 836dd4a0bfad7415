#include "ui/widgets/Steady.h"

#include "core/FormattedText.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kTooSmallToShow = 0.6;  ///< below this shown number the prefix becomes smaller
constexpr double kMargin = 0.08;         ///< room above and below the data, as a share of them
constexpr double kTooLoose = 0.4;        ///< the data fill less of the range than this
constexpr int kSteps = 5;                ///< round steps in a range, about
constexpr double kTooFaint = 0.2;        ///< share of the target below which a factor is too small

}  // namespace

SteadyScale::SteadyScale(std::string unit, double smallest)
    : unit_(std::move(unit)), smallest_(smallest), scale_(siScaleFor(smallest, unit_)) {}

const SiScale& SteadyScale::fit(double magnitude) {
    if (!std::isfinite(magnitude)) {
        return scale_;
    }
    const double counted = std::max(std::abs(magnitude), smallest_);
    SiScale fitting = siScaleFor(counted, unit_);
    const bool larger = fitting.factor < scale_.factor;
    if (larger || counted * scale_.factor < kTooSmallToShow) {
        scale_ = std::move(fitting);
    }
    return scale_;
}

SteadyRange::SteadyRange(double smallest)
    : smallest_(smallest), range_{-smallest / 2.0, smallest / 2.0} {}

const AxisRange& SteadyRange::fit(double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high)) {
        return range_;
    }
    // Data that hardly differ get the smallest range around them.
    const double missing = std::max(0.0, smallest_ - (high - low)) / 2.0;
    const AxisRange data{low - missing, high + missing};
    const double filled = (data.high - data.low) / (range_.high - range_.low);
    if (low >= range_.low && high <= range_.high && filled > kTooLoose) {
        return range_;
    }
    const double margin = kMargin * (data.high - data.low);
    const double step = niceBelow((data.high - data.low + 2.0 * margin) / kSteps);
    range_ = {std::floor((data.low - margin) / step) * step,
              std::ceil((data.high + margin) / step) * step};
    return range_;
}

double SteadyFactor::fit(double magnitude, double target) {
    if (!std::isfinite(magnitude)) {
        return factor_;
    }
    const double shown = factor_ * std::max(std::abs(magnitude), smallest_);
    if (shown > target || shown < kTooFaint * target) {
        factor_ = niceBelow(target / std::max(std::abs(magnitude), smallest_));
    }
    return factor_;
}

std::string scaledText(double value, const SiScale& scale, int decimals) {
    const double shown = value * scale.factor;
    if (!std::isfinite(shown)) {
        return "– " + scale.unit;
    }
    const double unit = std::pow(10.0, -decimals);
    const double rounded = std::abs(shown) < unit / 2.0 ? 0.0 : shown;  // never "-0.00"
    return formatted("%.*f ", decimals, rounded) + scale.unit;
}

std::string significantText(double value, const SiScale& scale) {
    constexpr double kRoundsUp = 0.9995;  // 9.995 and above read "10.00" with three digits
    const double shown = std::abs(value * scale.factor);
    if (!(shown > 0.0) || !std::isfinite(shown)) {
        return scaledText(value, scale, 0);
    }
    const int power = static_cast<int>(std::floor(std::log10(shown / kRoundsUp)));
    return scaledText(value, scale, std::max(0, 2 - power));
}

std::string threeDigitText(double value, const SiScale& scale) {
    const double shown = std::abs(value * scale.factor);
    if (shown < 0.005) {
        return "0 " + scale.unit;
    }
    return scaledText(value, scale, shown < 9.995 ? 2 : shown < 99.95 ? 1 : 0);
}

}  // namespace asperity
