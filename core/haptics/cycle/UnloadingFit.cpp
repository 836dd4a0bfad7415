#include "core/haptics/cycle/UnloadingFit.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kEndShare = 0.75;  ///< of the force at the deepest place
constexpr double kMinTicks = 4.0;
constexpr double kSure = 10.0;  ///< standard deviations of a slope

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
    force2_ += force * force;
}

Reading UnloadingFit::slopeOf(double sum, double sumOfSquares,
                              double sumOfProducts) const noexcept {
    const double spread = baseBase_ - base_ * base_ / count_;
    const double slope = (sumOfProducts - base_ * sum / count_) / spread;
    const double scatter = sumOfSquares - sum * sum / count_ - slope * slope * spread;
    return {.value = slope, .sigma = std::sqrt(std::max(0.0, scatter) / (count_ - 2.0) / spread)};
}

std::optional<Reading> UnloadingFit::stiffness() const noexcept {
    if (count_ < kMinTicks || !(baseBase_ * count_ > base_ * base_)) {
        return std::nullopt;
    }
    const Reading force = slopeOf(force_, force2_, baseForce_);
    const Reading separation = slopeOf(separation_, separation2_, baseSeparation_);
    if (!(force.value < -kSure * force.sigma) || !(separation.value > kSure * separation.sigma)) {
        return std::nullopt;
    }
    const double stiffness = -force.value / separation.value;
    // The same noise moves both slopes, in opposite directions.
    const double share = separation.sigma / separation.value - force.sigma / force.value;
    return Reading{.value = stiffness, .sigma = stiffness * share};
}

}  // namespace asperity
