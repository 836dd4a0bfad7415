#pragma once

#include "core/EnumTable.h"
#include "core/scene/SceneDescription.h"

#include <cstdint>

namespace asperity {

/// What of tip, lever and material a user changes most often.
enum class SceneParameter : std::uint8_t {
    TipRadius,
    SpringConstant,
    YoungsModulus,
    WorkOfAdhesion,
    Hardness,
};

/// How people see a parameter.
struct SceneParameterTraits {
    SceneParameter value;
    const char* key;      ///< of its field
    const char* caption;  ///< with the unit in which it is shown
    double unit;          ///< that unit [SI]
    double low;           ///< that can be entered [SI]
    double high;          ///< [SI]
    const char* toolTip;
};

template <>
inline constexpr auto kEnumTable<SceneParameter> = std::to_array<SceneParameterTraits>(
    {{SceneParameter::TipRadius, "tipRadius", "Tip radius [nm]", 1e-9, 1e-10, 1e-4,
      "Of the sphere that ends the tip"},
     {SceneParameter::SpringConstant, "springConstant", "Spring constant [N/m]", 1.0, 1e-3, 1e4,
      "Of the cantilever, at the tip along its normal; the beam's thickness follows"},
     {SceneParameter::YoungsModulus, "youngsModulus", "Young's modulus [GPa]", 1e9, 1e3, 2e12,
      "Of the sample"},
     {SceneParameter::WorkOfAdhesion, "workOfAdhesion", "Work of adhesion [mJ/m²]", 1e-3, 0.0, 1.0,
      "Of tip and sample; 0: no adhesion"},
     {SceneParameter::Hardness, "hardness", "Hardness [GPa]", 1e9, 0.0, 2e11,
      "Mean pressure under a plastic indent of the sample; 0: not known"}});

/// [SI]
[[nodiscard]] double parameterOf(const SceneDescription& scene, SceneParameter parameter) noexcept;

/// The same scene with another value [SI]. The instrument's truth goes along where it was what the
/// scene said. A changed material says so in its name.
[[nodiscard]] SceneDescription withParameter(SceneDescription scene, SceneParameter parameter,
                                             double value);

/// What the name of a changed material ends in.
inline constexpr const char* kEditedSuffix = " (edited)";

}  // namespace asperity
