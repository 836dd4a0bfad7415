#pragma once

#include "core/map/MapPlan.h"
#include "core/probe/TipEquilibrium.h"

namespace asperity {

/// Whether a quantity is the standard deviation of another one.
[[nodiscard]] bool isDeviation(MapQuantity quantity) noexcept;

/// Whether a map has standard deviations by model and calibration.
[[nodiscard]] bool hasDeviations(const MapPlan& plan);

/// Sets the standard deviations of a pixel's quantities by all inputs of [uncertainty] together,
/// from the landmarks of the contact law there: no cycle is repeated. NaN where the law has no such
/// landmark, the pixel no such quantity, or the tip several contacts. Takes as long as some ten
/// pixels.
/// @param setpoint state of the tip there
/// Source: docs/uncertainty.md 1.1.
void takeDeviations(const Scene& scene, const TipState& setpoint, MapValues& values);

}  // namespace asperity
