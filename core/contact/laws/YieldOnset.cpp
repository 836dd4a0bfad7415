#include "core/contact/laws/YieldOnset.h"

#include <cmath>

namespace asperity {

namespace {

constexpr double kHardnessOverYieldStress = 2.8;

}  // namespace

double yieldPressure(double hardness, double poissonRatio) noexcept {
    const double yieldStress = hardness / kHardnessOverYieldStress;
    return 1.295 * std::exp(0.736 * poissonRatio) * yieldStress;
}

}  // namespace asperity
