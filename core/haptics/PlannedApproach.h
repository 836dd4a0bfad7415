#pragma once

#include "core/EnumTable.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"

#include <cstdint>

namespace asperity {

/// An approach with the place where it begins.
struct PlannedApproach {
    Vector3 start = Vector3::Zero();  ///< of the base, out of the sample's reach, world [m]
    ApproachPlan plan;
};

/// Straight down to a setpoint and up again; by itself at the highest feature of the
/// scan. Speed and distances are such that all of it takes the plan's duration where the sample is
/// about as the scene says.
[[nodiscard]] PlannedApproach planApproach(const Scene& scene, const PathPlan& plan);

/// The movements that are planned on any scene.
enum class PlannedPath : std::uint8_t { Approach, Slide, Raster, Scratch };

struct PlannedPathRow {
    PlannedPath value;
    const char* key;
    const char* name;
    DevicePath (*plan)(const Scene& scene, const PathPlan& plan);  ///< null: planApproach()
};

template <>
inline constexpr auto kEnumTable<PlannedPath> =
    std::to_array<PlannedPathRow>({{PlannedPath::Approach, "approach", "Approach", nullptr},
                                   {PlannedPath::Slide, "slide", "Slide", slidePath},
                                   {PlannedPath::Raster, "raster", "Raster", rasterPath},
                                   {PlannedPath::Scratch, "scratch", "Scratch", scratchPath}});

}  // namespace asperity
