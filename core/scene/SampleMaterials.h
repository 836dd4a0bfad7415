#pragma once

#include "core/probe/MaterialMaps.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/SceneDescription.h"

#include <cstdint>
#include <memory>
#include <string>

namespace asperity {

/// Returns the maps that the material names.
/// @param where of the scene, for the message @throw Error where it names one that is not there
[[nodiscard]] MaterialMaps mapsOf(const SampleMaterial& material, const MaterialMaps& read,
                                  const std::string& where);

/// The material with the largest value of each map instead of its number: the stiffest and most
/// adhesive part of the sample, by which a model is chosen, and devices and paths are limited.
[[nodiscard]] SampleMaterial withLargest(SampleMaterial material, const MaterialMaps& maps);

/// The law of the softest part of a sample with the adhesion of the most adhesive one: no part lets
/// a tip go later.
[[nodiscard]] ContactModel softestContact(const ProbeSystem& system) noexcept;

/// Returns the material that the tip meets at each position; null without maps.
/// @param friction where there is no map of it
[[nodiscard]] std::shared_ptr<const MaterialField> materialField(MaterialMaps maps,
                                                                 const SampleMaterial& material,
                                                                 const Friction& friction,
                                                                 const Elastic& tip);

/// Source of the hardness by which yield is judged.
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
