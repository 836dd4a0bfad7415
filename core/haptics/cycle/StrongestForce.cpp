#include "core/haptics/cycle/StrongestForce.h"

#include <algorithm>
#include <cmath>

namespace asperity {

Reading StrongestForce::meanOf(const std::array<HalfForce, 2>& halves) noexcept {
    return {.value = 0.5 * (halves[0].force + halves[1].force),
            .sigma = 0.5 * std::hypot(halves[0].sigma, halves[1].sigma)};
}

bool StrongestForce::take(const std::array<HalfForce, 2>& halves, double force,
                          const DepthBeside& depth) noexcept {
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const double sure = halves[i].smooth - (caution_ * halves[i].smoothSigma);
        if (!reading_ || sure > strongest_[i]) {
            strongest_[i] = sure;
            measured_[i] = halves[1 - i];
            measuredDepth_[i] = depth.halves[1 - i];
            pickSigma_[i] = depth.stiffness > 0.0 ? halves[i].smoothSigma / depth.stiffness : 0.0;
        }
    }
    const bool isStrongest = !reading_ || force > strongestForce_;
    strongestForce_ = isStrongest ? force : strongestForce_;
    reading_ = meanOf(measured_);
    return isStrongest;
}

Reading StrongestForce::readingBeside() const noexcept {
    Reading depth = meanOf(measuredDepth_);
    depth.sigma = std::hypot(depth.sigma, 0.5 * std::hypot(pickSigma_[0], pickSigma_[1]));
    return depth;
}

void StrongestPlaces::take(double force, double sigma, double place) noexcept {
    // In standard deviations: how far below the strongest a force counts as equal, and how far
    // above the first one it shows that the place is another.
    constexpr double kWeaker = 3.0;
    constexpr double kStronger = 5.0;
    if (!started_ || force > first_ + kStronger * sigma) {
        started_ = true;
        first_ = strongest_ = force;
        lowest_ = highest_ = place;
    }
    strongest_ = std::max(strongest_, force);
    if (force >= strongest_ - kWeaker * sigma) {
        lowest_ = std::min(lowest_, place);
        highest_ = std::max(highest_, place);
    }
}

double StrongestPlaces::sigmaOf(double place) const noexcept {
    return std::max(place - lowest_, highest_ - place) / std::sqrt(3.0);
}

}  // namespace asperity
