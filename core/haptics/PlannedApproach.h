#pragma once

#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"

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

}  // namespace asperity
