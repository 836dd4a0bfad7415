#include "core/haptics/LiftStep.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kShare = 0.25;  // of the height that one notch takes, far away

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

}  // namespace asperity
