#include "ui/view/ForceScale.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMemory = 0.4;        // time after which a peak counts a third [s]
constexpr double kNoiseInRoom = 10.0;  // the room holds so many standard deviations at least

}  // namespace

double ForceScale::fit(double magnitude, double sigma, double time, double room) {
    if (!std::isfinite(magnitude) || !std::isfinite(sigma)) {
        return factor_.factor();
    }
    const double passed = std::max(0.0, time - time_);
    time_ = time;
    peak_ = std::max(magnitude, peak_ * std::exp(-passed / kMemory));
    return factor_.fit(std::max(peak_, kNoiseInRoom * sigma), room);
}

}  // namespace asperity
