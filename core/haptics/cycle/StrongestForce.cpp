#include "core/haptics/cycle/StrongestForce.h"

#include <cmath>

namespace asperity {

bool StrongestForce::take(const std::array<HalfForce, 2>& halves, double force) noexcept {
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const double sure = halves[i].smooth - (caution_ * halves[i].smoothSigma);
        if (!reading_ || sure > strongest_[i]) {
            strongest_[i] = sure;
            measured_[i] = halves[1 - i];
        }
    }
    const bool isStrongest = !reading_ || force > strongestForce_;
    strongestForce_ = isStrongest ? force : strongestForce_;
    reading_ = {.value = 0.5 * (measured_[0].force + measured_[1].force),
                .sigma = 0.5 * std::hypot(measured_[0].sigma, measured_[1].sigma)};
    return isStrongest;
}

}  // namespace asperity
