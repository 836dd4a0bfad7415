#include "core/scene/RadialTable.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace asperity {

namespace {

/// Value at `part` (0 .. 1) of evenly spread samples.
double interpolated(std::span<const double> samples, double part) {
    const auto intervals = static_cast<double>(samples.size() - 1);
    const double place = std::clamp(part, 0.0, 1.0) * intervals;
    const auto left = static_cast<std::size_t>(std::min(place, intervals - 1.0));
    return std::lerp(samples[left], samples[left + 1], place - static_cast<double>(left));
}

}  // namespace

// Samples lie at the squares of even steps from the rim, both ways.
RadialTable::RadialTable(const std::function<double(double)>& function, double rim, double reach)
    : rim_(rim), reach_(std::max(reach, rim)) {
    for (int i = 0; i <= kInside; ++i) {
        const double part = static_cast<double>(i) / kInside;
        inside_.at(static_cast<std::size_t>(i)) = function(rim_ * (1.0 - part * part));
    }
    for (int i = 0; i <= kOutside; ++i) {
        const double part = static_cast<double>(i) / kOutside;
        outside_.at(static_cast<std::size_t>(i)) = function(std::lerp(rim_, reach_, part * part));
    }
}

double RadialTable::at(double distance) const {
    if (distance < rim_) {
        return interpolated(inside_, std::sqrt(1.0 - distance / rim_));
    }
    if (!(reach_ > rim_)) {
        return outside_.back();
    }
    return interpolated(outside_, std::sqrt((distance - rim_) / (reach_ - rim_)));
}

}  // namespace asperity
