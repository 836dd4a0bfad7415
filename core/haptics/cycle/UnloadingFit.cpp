#include "core/haptics/cycle/UnloadingFit.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kEndShare = 0.75;  ///< of the force at the deepest place
constexpr double kMinTicks = 4.0;
constexpr double kSure = 3.0;  ///< standard deviations of a slope

}  // namespace

void UnloadingFit::restart(const ForceDistancePoint& deepest, double force) noexcept {
    *this = {};
    open_ = force > 0.0;
    endForce_ = kEndShare * force;
    first_ = deepest;
    add(deepest);
}

void UnloadingFit::take(const ForceDistancePoint& point, double force) noexcept {
    open_ = open_ && force >= endForce_;
    if (open_) {
        add(point);
    }
}

void UnloadingFit::add(const ForceDistancePoint& point) noexcept {
    const double base = point.baseDistance - first_.baseDistance;
    const double separation = point.separation - first_.separation;
    const double force = point.force - first_.force;
    count_ += 1.0;
    base_ += base;
    force_ += force;
    separation_ += separation;
    baseBase_ += base * base;
    baseForce_ += base * force;
    baseSeparation_ += base * separation;
    separation2_ += separation * separation;
}

std::optional<Reading> UnloadingFit::stiffness() const noexcept {
    const double spread = baseBase_ - base_ * base_ / count_;
    if (count_ < kMinTicks || !(spread > 0.0)) {
        return std::nullopt;
    }
    const double forceSlope = (baseForce_ - base_ * force_ / count_) / spread;
    const double slope = (baseSeparation_ - base_ * separation_ / count_) / spread;
    const double scatter =
        separation2_ - separation_ * separation_ / count_ - slope * slope * spread;
    const double sigma = std::sqrt(std::max(0.0, scatter) / (count_ - 2.0) / spread);
    if (!(forceSlope < 0.0) || !(slope > kSure * sigma)) {
        return std::nullopt;
    }
    const double stiffness = -forceSlope / slope;
    return Reading{.value = stiffness, .sigma = stiffness * sigma / slope};
}

}  // namespace asperity
