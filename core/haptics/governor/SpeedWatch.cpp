#include "core/haptics/governor/SpeedWatch.h"

namespace asperity {

namespace {

constexpr double kStretch = 2e-3;   // [s]
constexpr double kRounding = 1e-9;  // of a sum of time steps, relative

}  // namespace

SpeedWatch watchSpeed(const SpeedWatch& watch, const Vector3& position, double timeStep) noexcept {
    if (!watch.started) {
        return {.from = position, .started = true};
    }
    SpeedWatch next = watch;
    next.time += timeStep;
    if (next.time >= kStretch * (1.0 - kRounding)) {
        next.speed = (position - watch.from).stableNorm() / next.time;
        next.from = position;
        next.time = 0.0;
    }
    return next;
}

}  // namespace asperity
