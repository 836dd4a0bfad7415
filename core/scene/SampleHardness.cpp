#include "core/scene/SampleHardness.h"

namespace asperity {

namespace {

constexpr double kHardnessOverModulus = 1.0 / 20.0;
constexpr double kMinEstimatedModulus = 1e9;  ///< [Pa]

}  // namespace

SampleHardness hardnessOf(const SampleMaterial& material) noexcept {
    if (!material.yields) {
        return {.source = HardnessSource::DoesNotYield};
    }
    if (material.hardness > 0.0) {
        return {.source = HardnessSource::Stated, .value = material.hardness};
    }
    const bool isMapped = material.maps.youngsModulus || material.maps.mask;
    const double modulus = material.elastic.youngsModulus;
    return isMapped || modulus < kMinEstimatedModulus
               ? SampleHardness{}
               : SampleHardness{.source = HardnessSource::Estimated,
                                .value = kHardnessOverModulus * modulus};
}

}  // namespace asperity
