#include "ui/ColorRange.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kPercent = 0.01;
constexpr double kPermille = 0.001;

double leftOutBy(RangeRule rule) {
    switch (rule) {
    case RangeRule::Percent:
        return kPercent;
    case RangeRule::Permille:
        return kPermille;
    case RangeRule::Full:
    case RangeRule::Own:
        break;
    }
    return 0.0;
}

/// Values that are all the same get a range around them.
ValueRange widened(const ValueRange& range, double smallest) {
    const double missing = 0.5 * (smallest - (range.high - range.low));
    return missing > 0.0 ? ValueRange{range.low - missing, range.high + missing} : range;
}

bool isSame(const ValueRange& one, const ValueRange& other) {
    return one.low == other.low && one.high == other.high;
}

}  // namespace

double ColorRange::smallest(SurfaceQuantity quantity) {
    switch (quantity) {
    case SurfaceQuantity::Height:
    case SurfaceQuantity::Gap:
    case SurfaceQuantity::Displacement:
    case SurfaceQuantity::Residual:
        return 1e-10;  // [m]
    case SurfaceQuantity::Pressure:
        return 1e3;  // [Pa]
    case SurfaceQuantity::Slope:
        return 1e-3;  // [rad]
    case SurfaceQuantity::Certainty:
        return 1.0;
    case SurfaceQuantity::YoungsModulus:
    case SurfaceQuantity::WorkOfAdhesion:
    case SurfaceQuantity::FrictionCoefficient:
    case SurfaceQuantity::Channel:
    case SurfaceQuantity::ForceMap:
        break;
    }
    return 1e-30;  // whatever its unit
}

ValueRange ColorRange::wished(std::span<const double> values, const Wish& wish) {
    const QuantityColors& colors = wish.colors;
    if (colors.rule == RangeRule::Own) {
        return {colors.low, colors.high};
    }
    ValueRange range = rangeOf(values, leftOutBy(colors.rule));
    if (wish.isSigned && colors.map == ColorMap::Diverging) {
        const double largest = std::max(std::abs(range.low), std::abs(range.high));
        range = {-largest, largest};
    }
    if (wish.isSteady) {
        const AxisRange& axis = steady_.fit(range.low, range.high);
        return {axis.low, axis.high};
    }
    return range;
}

bool ColorRange::fit(std::span<const double> values, const Wish& wish) {
    const ValueRange dataBefore = data_;
    const ValueRange before = range_;
    const bool had = hasData_;
    hasData_ = std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
    if (hasData_) {
        data_ = rangeOf(values);
        const bool isRest = wish.isSteady && wish.colors.rule != RangeRule::Own &&
                            data_.low == 0.0 && data_.high == 0.0;
        if (!isRest && (!wish.colors.pinned || !isFitted_)) {
            const double some = 1e-12 * std::max(std::abs(data_.low), std::abs(data_.high));
            range_ = widened(wished(values, wish), std::max(some, smallest_));
            isFitted_ = true;
        }
    }
    return had != hasData_ || !isSame(before, range_) || !isSame(dataBefore, data_);
}

void ColorRange::describe(ColorScale& scale, const QuantityColors& colors) const {
    if (hasData_) {
        scale.dataLow = data_.low;
        scale.dataHigh = data_.high;
    }
    if (colors.pinned) {
        scale.rule = QObject::tr("pinned");
    } else if (colors.rule == RangeRule::Own) {
        scale.rule = QObject::tr("own range");
    } else if (colors.rule != RangeRule::Full) {
        scale.rule = QObject::tr(nameOf(colors.rule));
    }
}

ColorRanges::ColorRanges() {
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        ranges_.emplace_back(quantity);
    }
}

void ColorRanges::setChannel(const QString& name) {
    if (!name.isEmpty() && name != channel_) {
        channel_ = name;
        of(SurfaceQuantity::Channel) = ColorRange(SurfaceQuantity::Channel);
    }
}

}  // namespace asperity
