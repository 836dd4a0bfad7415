#include "core/contact/Material.h"

namespace asperity {

namespace {

/// (1 - nu^2) / E [1/Pa]; zero for a rigid body (E infinite).
double planeCompliance(const Elastic& body) noexcept {
    return (1.0 - (body.poissonRatio * body.poissonRatio)) / body.youngsModulus;
}

}  // namespace

double reducedModulus(const Elastic& sample, const Elastic& tip) noexcept {
    return 1.0 / (planeCompliance(sample) + planeCompliance(tip));
}

double sampleShare(const Elastic& sample, const Elastic& tip) noexcept {
    return planeCompliance(sample) * reducedModulus(sample, tip);
}

}  // namespace asperity
