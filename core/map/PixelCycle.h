#pragma once

#include "core/map/MapInstrument.h"
#include "core/map/MapQuantity.h"

namespace asperity {

/// All quantities of mode `approach` at a place: the tip approaches until the force along z is the
/// setpoint, and retracts until it is free. It depends on nothing else: every pixel begins with a
/// fresh memory and without noise. What was not found is NaN, and the flags say why.
/// On one contact point snap-in and pull-off are those of the contact law at the place's effective
/// radius, as `asperity curve` shows them.
/// @param place world x, y [m] @param setpoint [N]
[[nodiscard]] MapValues pixelCycle(const MapInstrument& instrument, const Vector2& place,
                                   double setpoint);

}  // namespace asperity
