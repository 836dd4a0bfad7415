#include "core/contact/Material.h"

#include "core/contact/Within.h"

#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kNoUpperLimit = std::numeric_limits<double>::infinity();

/// Whether it is an elastic body or a rigid one; quiet for what is not a number.
bool isBody(const Elastic& body) noexcept {
    constexpr double kMinModulus = 1e-100;  // so that no compliance overflows [Pa]
    const bool rigid = std::isinf(body.youngsModulus) && !std::signbit(body.youngsModulus);
    return isWithin(body.poissonRatio, 0.0, 0.5) &&
           (rigid || isWithin(body.youngsModulus, kMinModulus, std::numeric_limits<double>::max()));
}

/// (1 - nu^2) / E [1/Pa]; zero for a rigid body (E infinite).
double planeCompliance(const Elastic& body) noexcept {
    return (1.0 - (body.poissonRatio * body.poissonRatio)) / body.youngsModulus;
}

}  // namespace

double reducedModulus(const Elastic& sample, const Elastic& tip) noexcept {
    if (!isBody(sample) || !isBody(tip)) {
        return 0.0;
    }
    const double compliance = planeCompliance(sample) + planeCompliance(tip);
    return compliance > 1.0 / std::numeric_limits<double>::max() ? 1.0 / compliance : kNoUpperLimit;
}

double sampleShare(const Elastic& sample, const Elastic& tip) noexcept {
    const double modulus = reducedModulus(sample, tip);
    const bool shared = modulus > 0.0 && std::isfinite(modulus);
    return shared ? planeCompliance(sample) * modulus : 0.0;
}

}  // namespace asperity
