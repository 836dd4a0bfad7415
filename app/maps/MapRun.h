#pragma once

#include "app/maps/MapPart.h"
#include "core/Progress.h"

namespace asperity {

struct Scene;

/// Computes the rows of a map that its part lacks, each on one thread, and keeps them there. The
/// values do not depend on the number of threads.
/// @param threads 0: as many as the machine has cores
/// @param progress may be null; of the whole map
/// @throw Canceled: the rows finished until then are kept; Error where the part cannot be written
void computeMap(const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
                Progress* progress);

}  // namespace asperity
