#include "core/deformation/RadialTable.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace asperity {

namespace {

/// How far away "far away" is, in scales.
constexpr double kFar = 1e9;

/// Value at `part` (0 .. 1) of evenly spread samples: the cubic through the four around it.
double interpolated(std::span<const double> samples, double part) {
    const auto intervals = static_cast<double>(samples.size() - 1);
    const double place = std::clamp(part, 0.0, 1.0) * intervals;
    const auto first = static_cast<std::size_t>(std::clamp(place - 1.0, 0.0, intervals - 3.0));
    const double t = place - static_cast<double>(first);  // of the first, in intervals
    const double a = t - 1.0;
    const double b = t - 2.0;
    const double c = t - 3.0;
    return (-samples[first] * a * b * c + 3.0 * samples[first + 1] * t * b * c -
            3.0 * samples[first + 2] * t * a * c + samples[first + 3] * t * a * b) /
           6.0;
}

}  // namespace

// Samples lie at the squares of even steps from the rim, both ways; outwards, those of a variable
// that goes from 0 at the rim to 1 far away, in which what falls off with the distance is smooth.
RadialTable::RadialTable(const std::function<double(double)>& function, double rim, double scale)
    : rim_(rim), scale_(scale) {
    for (int i = 0; i <= kInside; ++i) {
        const double part = static_cast<double>(i) / kInside;
        inside_.at(static_cast<std::size_t>(i)) = function(rim_ * (1.0 - part * part));
    }
    for (int i = 0; i <= kOutside; ++i) {
        const double part = static_cast<double>(i) / kOutside;
        const double away = part * part / std::max(1.0 - part * part, 1.0 / kFar);
        outside_.at(static_cast<std::size_t>(i)) = function(rim_ + scale_ * away);
    }
}

double RadialTable::at(double distance) const {
    if (distance < rim_) {
        return interpolated(inside_, std::sqrt(1.0 - distance / rim_));
    }
    const double away = (distance - rim_) / scale_;
    return interpolated(outside_, std::sqrt(away / (1.0 + away)));
}

}  // namespace asperity
