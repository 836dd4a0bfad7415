#pragma once

#include "core/scene/SceneFields.h"

#include <cstdint>
#include <string>

namespace asperity {

/// Measured property of a lever: it stays where length, width, density or modulus change.
enum class LeverCalibration : std::uint8_t {
    Thickness,
    Stiffness,
    Resonance,
    StiffnessAndResonance,  ///< thickness and modulus follow
};

template <>
inline constexpr auto kEnumTable<LeverCalibration> = std::to_array<EnumRow<LeverCalibration>>(
    {{LeverCalibration::Thickness, "thickness"},
     {LeverCalibration::Stiffness, "stiffness"},
     {LeverCalibration::Resonance, "resonance"},
     {LeverCalibration::StiffnessAndResonance, "stiffness_and_resonance",
      "stiffness and resonance"}});

/// The scene with another value of a key. Along go the instrument's truth where it was what the
/// scene said, the lever by its calibration, and the name of a material that is another now.
/// @throw Error where no lever has such a calibration
[[nodiscard]] SceneDescription withValue(const SceneDescription& scene, const SceneField& field,
                                         const SceneValue& value, LeverCalibration calibration);

/// Sets the instrument's truth to the scene's values where it had those of the scene before.
void carryTruth(const SceneDescription& before, SceneDescription& scene);

/// The scene that says nothing but its file or shape: the values that keys have by default.
[[nodiscard]] SceneDescription defaultsOf(const SceneDescription& scene);

/// Returns whether a key has the same value in both, up to rounding.
[[nodiscard]] bool isSame(const SceneField& field, const SceneDescription& a,
                          const SceneDescription& b);

/// Returns why a key of the sample means nothing for it, be it a scan or a shape; empty: it means
/// something.
[[nodiscard]] std::string whyNotOfSample(const SceneField& field, const SceneDescription& scene);

/// Returns why a key means nothing in a scene; empty: it means something.
[[nodiscard]] std::string whyIdle(const SceneField& field, const SceneDescription& scene);

/// Suffix of the name of a changed material.
inline constexpr const char* kEditedSuffix = " (edited)";

}  // namespace asperity
