#pragma once

#include "app/maps/ComparedMap.h"
#include "app/maps/MapFiles.h"

#include <span>

namespace asperity {

/// Draws a sheet for each comparison: measured and predicted map, difference and residual, and the
/// measured values over the predicted ones with their line.
/// @throw Error when no display answers, or a file cannot be written
void writeComparisonSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part,
                           std::span<const ComparedMap> maps);

}  // namespace asperity
