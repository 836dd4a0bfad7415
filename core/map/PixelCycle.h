#pragma once

#include "core/map/Engagement.h"
#include "core/map/MapInstrument.h"
#include "core/map/MapQuantity.h"
#include "core/map/RetractCurve.h"

#include <optional>

namespace asperity {

/// The states of a cycle of mode `approach` that a pixel's quantities come from; as much of it as
/// there is.
struct CycleStates {
    std::optional<Engagement> engaged;
    std::optional<RetractCurve> retracted;  ///< none: it does not engage, or stays bonded
    std::optional<double> dissipated;       ///< by adhesion, not friction [J]
};

/// Lowers the tip at the path's place, a fresh one, until the force along z is the setpoint [N],
/// and raises it until it is free.
[[nodiscard]] CycleStates runCycle(VerticalPath& path, double setpoint);

/// All quantities of a cycle. @param path that it was run on, and nothing else since
[[nodiscard]] MapValues valuesOf(const CycleStates& states, const VerticalPath& path);

/// All quantities of mode `approach` at a place: the tip approaches until the force along z is the
/// setpoint, and retracts until it is free. It depends on nothing else: every pixel begins with a
/// fresh memory and without noise. What was not found is NaN, and the flags say why.
/// On one contact point snap-in and pull-off are those of the contact law at the place's effective
/// radius, as `asperity curve` shows them.
/// @param place world x, y [m] @param setpoint [N]
[[nodiscard]] MapValues pixelCycle(const MapInstrument& instrument, const Vector2& place,
                                   double setpoint);

}  // namespace asperity
