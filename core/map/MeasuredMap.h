#pragma once

#include "core/map/MapPlan.h"
#include "core/surface/HeightMap.h"

#include <optional>
#include <vector>

namespace asperity {

/// The area that a measured map of this size shows [m]: the plan's region or the whole scan,
/// whichever it fits better; none: neither fits to 2 % of each side.
/// @param scan the whole scan, world frame
[[nodiscard]] std::optional<MapRegion> measuredArea(double width, double height,
                                                    const MapPlan& plan, const MapRegion& scan);

/// A measured map at the centers of a plan's pixels, row by row from the top: bilinear between its
/// own pixel centers, constant beyond the outermost ones; NaN where a pixel that it needs holds no
/// data. Where the centers coincide, a pixel's own value.
/// @param measured values in any unit, NaN or marked where there are no data
/// @param area     that it covers, world [m]
[[nodiscard]] std::vector<double> valuesAt(const MapPlan& plan, const HeightMap& measured,
                                           const MapRegion& area);

}  // namespace asperity
