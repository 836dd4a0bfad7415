#pragma once

#include "core/map/JumpSearch.h"
#include "core/map/MapPlan.h"
#include "core/map/MapQuantity.h"
#include "core/map/RetractCurve.h"
#include "core/probe/TipEquilibrium.h"

#include <optional>
#include <vector>

namespace asperity {

/// The states of a cycle of mode `approach` that a pixel's quantities come from; as much of it as
/// there is.
struct CycleStates {
    std::optional<Engagement> engaged;
    std::optional<RetractCurve> retracted;  ///< none: it does not engage, or stays bonded
    std::optional<double> dissipated;       ///< by adhesion, not friction [J]
};

/// Lowers the tip at the path's position, a fresh one, until the force along z is the setpoint [N],
/// and raises it until it is free.
[[nodiscard]] CycleStates runCycle(VerticalPath& path, double setpoint);

/// All quantities of a cycle. @param path that it was run on, and nothing else since
[[nodiscard]] MapValues valuesOf(const CycleStates& states, const VerticalPath& path);

/// All quantities of mode `approach` at a position: the tip approaches until the force along z is
/// the setpoint, and retracts until it is free. It depends on nothing else: every pixel begins with
/// a fresh memory and without noise. What was not found is NaN, and the flags say why. On one
/// contact point snap-in and pull-off are those of the contact law at the position's effective
/// radius, as `asperity curve` shows them.
/// @param position world x, y [m] @param setpoint [N]
[[nodiscard]] MapValues pixelCycle(const MapInstrument& instrument, const Vector2& position,
                                   double setpoint);

/// Returns the energy that adhesion dissipates in a cycle [J], for any number of contact points and
/// whatever order they change in: area between approach and retract, of the force along z over the
/// base, from the setpoint to the pull-off, both without friction. Trapezoids between some 30
/// states of each. None: the tip stays bonded.
[[nodiscard]] std::optional<double> loopEnergy(VerticalPath& path, const Engagement& engaged);

/// Returns whether a quantity is the standard deviation of another one.
[[nodiscard]] bool isDeviation(MapQuantity quantity) noexcept;

/// Returns whether a map has standard deviations by model and calibration.
[[nodiscard]] bool hasDeviations(const MapPlan& plan);

/// Sets the standard deviations of a pixel's quantities by all inputs of [uncertainty] together,
/// from the landmarks of the contact law there: no cycle is repeated. NaN where the law has no such
/// landmark, the pixel no such quantity, or the tip several contacts. Takes as long as some ten
/// pixels.
/// @param setpoint state of the tip there
/// Source: docs/uncertainty.md 1.1.
void takeDeviations(const Scene& scene, const TipState& setpoint, MapValues& values);

/// A point of a pixel's force curve.
struct PixelCurvePoint {
    double base = 0.0;   ///< height of the base [m]
    double tip = 0.0;    ///< height of the tip as the instrument records it [m]
    double force = 0.0;  ///< along z, > 0 pushes [N]
};

/// The force curve of a pixel of mode `approach`, with what the map has there.
struct PixelCurve {
    /// Curve from above the sample to the setpoint; a snap-in is two points at one height of the
    /// base.
    std::vector<PixelCurvePoint> approach;
    /// Curve from the setpoint until the tip is free; a pull-off is two points, too. Its strongest
    /// pull is the adhesion force.
    std::vector<PixelCurvePoint> retract;
    std::optional<PixelCurvePoint> snapIn;   ///< just before it; none: the force does not jump
    std::optional<PixelCurvePoint> pullOff;  ///< same; the map's pull-off force
    MapValues values;                        ///< as pixelCycle() gives them
};

/// Records the curve that the quantities of a pixel come from. Empty where the tip does not engage,
/// without retract where it stays bonded. @param position world x, y [m] @param setpoint [N]
[[nodiscard]] PixelCurve pixelCurve(const MapInstrument& instrument, const Vector2& position,
                                    double setpoint);

}  // namespace asperity
