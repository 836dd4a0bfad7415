#pragma once

#include "core/map/MapPlan.h"

#include <string_view>
#include <vector>

namespace asperity {

/// Whether an instrument may measure the quantity: not flags and counts of the computation, nor
/// what model and calibration leave open.
[[nodiscard]] bool isMeasurable(MapQuantity quantity);

/// The quantities of a plan that a measured channel may show: those of its unit; of several, those
/// whose key has the most words of its title. None, one, or several between which only the user can
/// decide.
/// @param unit SI @param title "Adhesion", "HeightSensor"
[[nodiscard]] std::vector<MapQuantity> quantitiesLike(const MapPlan& plan, std::string_view unit,
                                                      std::string_view title);

}  // namespace asperity
