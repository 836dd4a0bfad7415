#pragma once

#include "core/ShareOut.h"
#include "core/map/MapInstrument.h"
#include "core/map/MapPlan.h"

#include <vector>

namespace asperity {

/// One row of a map, 0 at the top: for each quantity of the plan, in its order, a value for each
/// column, in the quantity's unit; NaN where there is none. It depends on nothing but its
/// arguments.
/// @throw Canceled
[[nodiscard]] std::vector<double> mapRow(const MapInstrument& instrument, const MapPlan& plan,
                                         int row, const CancelCheck& check = {});

}  // namespace asperity
