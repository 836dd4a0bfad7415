#pragma once

#include "core/experiment/TrialPlan.h"

namespace asperity {

struct Scene;

/// Where the tip begins, and where it shall be [m].
struct TrialPlaces {
    Vector3 start;
    Vector3 target;
};

[[nodiscard]] TrialPlaces placesOf(const Study& study, const Scene& scene,
                                   const PlannedTrial& trial);

}  // namespace asperity
