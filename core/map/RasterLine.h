#pragma once

#include "core/ShareOut.h"
#include "core/map/MapInstrument.h"
#include "core/map/MapPlan.h"

#include <vector>

namespace asperity {

/// All quantities of mode `contact` in one row of a map: the tip engages at the left end, is drawn
/// to the right end (trace) and back (retrace), while the base keeps the force along z at the
/// setpoint; friction has its full direction. It depends on nothing else. Where the tip is lost it
/// engages anew at the next pixel.
/// @throw Canceled
[[nodiscard]] std::vector<MapValues>
rasterLine(const MapInstrument& instrument, const MapPlan& plan, int row, const CancelCheck& check);

}  // namespace asperity
