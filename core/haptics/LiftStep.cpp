#include "core/haptics/LiftStep.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kShare = 0.25;               // of the height that one notch takes, far away
constexpr double kOfHalfWidth = 1.0 / 400.0;  // 0.1 nm in a view of 80 nm
constexpr double kOfSetpoint = 0.2;
constexpr double kAlwaysFine = 0.1e-9;  // [m]

}  // namespace

// Counted in notches from the sample the height is linear up to fineStep / kShare, where a notch is
// that share of it, and exponential from there on: step and slope are continuous.
double liftedHeight(double height, double notches, double fineStep) noexcept {
    constexpr double kBendNotches = 1.0 / kShare;
    const double bend = kBendNotches * fineStep;
    const double from =
        height <= bend ? height / fineStep : kBendNotches * (1.0 + std::log(height / bend));
    const double to = from + notches;
    return to <= kBendNotches ? to * fineStep : bend * std::exp(to / kBendNotches - 1.0);
}

double fineLiftStep(double halfWidth, double setpoint, double stiffness) noexcept {
    return std::min(kOfHalfWidth * halfWidth,
                    std::max(kAlwaysFine, kOfSetpoint * setpoint / stiffness));
}

}  // namespace asperity
