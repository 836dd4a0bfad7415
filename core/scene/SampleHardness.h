#pragma once

#include "core/scene/SceneDescription.h"

#include <cstdint>

namespace asperity {

/// How the hardness is known by which yield is judged.
enum class HardnessSource : std::uint8_t {
    Stated,
    Estimated,     ///< from the modulus
    Unknown,       ///< yield is not judged
    DoesNotYield,  ///< an elastomer or a gel breaks before it yields
};

/// The hardness of a sample, by which its yield is judged.
struct SampleHardness {
    HardnessSource source = HardnessSource::Unknown;
    double value = 0.0;  ///< [Pa]; 0: unknown, or there is none
};

/// Returns the hardness of a material, estimated where it is not stated and the modulus is 1 GPa or
/// more: E/20, about the middle of E/7 (glassy polymers, fused silica) to E/80 (soft metals), so
/// within a factor of 4. Softer materials, whose hardness and modulus have no common ratio, and
/// those of mapped moduli are unknown. No allocation. Sources: hardness over modulus of glasses,
/// ceramics and metals, Tabor, The Hardness of Metals (1951); Johnson, Contact Mechanics (1985),
/// chapter 6.
[[nodiscard]] SampleHardness hardnessOf(const SampleMaterial& material) noexcept;

}  // namespace asperity
