#pragma once

#include "core/map/PixelCycle.h"

#include <optional>
#include <vector>

namespace asperity {

/// A point of a pixel's force curve.
struct PixelCurvePoint {
    double base = 0.0;   ///< height of the base [m]
    double tip = 0.0;    ///< height of the tip as the instrument records it [m]
    double force = 0.0;  ///< along z, > 0 pushes [N]
};

/// The force curve of a pixel of mode `approach`, with what the map has there.
struct PixelCurve {
    /// From above the sample to the setpoint; a snap-in is two points at one height of the base.
    std::vector<PixelCurvePoint> approach;
    /// From the setpoint until the tip is free; likewise with a pull-off. Its strongest pull is the
    /// adhesion force.
    std::vector<PixelCurvePoint> retract;
    std::optional<PixelCurvePoint> snapIn;   ///< just before it; none: the force does not jump
    std::optional<PixelCurvePoint> pullOff;  ///< likewise; the map's pull-off force
    MapValues values;                        ///< as pixelCycle() gives them
};

/// Records the curve that the quantities of a pixel come from. Empty where the tip does not engage,
/// without retract where it stays bonded. @param place world x, y [m] @param setpoint [N]
[[nodiscard]] PixelCurve pixelCurve(const MapInstrument& instrument, const Vector2& place,
                                    double setpoint);

}  // namespace asperity
