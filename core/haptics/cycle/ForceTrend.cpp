#include "core/haptics/cycle/ForceTrend.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kMemory = 20;    ///< ticks
constexpr double kJump = 6.0;  ///< standard deviations of a tick off the line

}  // namespace

void ForceTrend::take(double force, double sigma) noexcept {
    const double expected = force_ + slope_;
    const double surprise = force - expected;
    if (ticks_ == 0 || std::abs(surprise) > kJump * std::hypot(sigma, sigma_)) {
        *this = {};
        force_ = force;
        sigma_ = sigma;
        ticks_ = 1;
        return;
    }
    const double n = ticks_;
    const double gain = 2.0 * (2.0 * n + 1.0) / ((n + 1.0) * (n + 2.0));
    force_ = expected + gain * surprise;
    slope_ += 6.0 / ((n + 1.0) * (n + 2.0)) * surprise;
    sigma_ = std::sqrt(gain) * sigma;
    ticks_ = std::min(ticks_ + 1, kMemory);
}

}  // namespace asperity
