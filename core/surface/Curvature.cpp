#include "core/surface/Curvature.h"

#include <algorithm>

namespace asperity {

PrincipalCurvatures principalCurvatures(const HeightSample& sample) noexcept {
    const double p = sample.dx;
    const double q = sample.dy;
    const double s2 = 1.0 + p * p + q * q;
    const double mean =
        ((1.0 + q * q) * sample.dxx - 2.0 * p * q * sample.dxy + (1.0 + p * p) * sample.dyy) /
        (2.0 * s2 * std::sqrt(s2));
    const double gaussian = (sample.dxx * sample.dyy - sample.dxy * sample.dxy) / (s2 * s2);
    const double spread = std::sqrt(std::max(0.0, mean * mean - gaussian));
    return {-mean + spread, -mean - spread};
}

}  // namespace asperity
