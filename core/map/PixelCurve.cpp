#include "core/map/PixelCurve.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr int kFreePoints = 32;    // of the way down to the snap-in
constexpr int kBondedPoints = 24;  // of the way from there to the setpoint

PixelCurvePoint curvePointAt(const VerticalPath& path, double base, double force) {
    return {.base = base, .tip = base + (path.complianceZ() * force), .force = force};
}

PixelCurvePoint curvePointOf(const VerticalPath& path, const TipAtHeight& tip) {
    return curvePointAt(path, tip.base, tip.force());
}

PixelCurvePoint curvePointOf(const VerticalPath& path, const RetractPoint& point) {
    return {.base = point.height - (path.complianceZ() * point.force),
            .tip = point.height,
            .force = point.force};
}

/// The two sides of a jump, before it and after it.
std::pair<PixelCurvePoint, PixelCurvePoint> sidesOf(const VerticalPath& path,
                                                    const FoundJump& jump) {
    return {curvePointAt(path, jump.base, jump.forceBefore()),
            curvePointAt(path, jump.base, jump.forceAfter())};
}

/// Where the tip of a retract is free, the approach begins: both show the same way.
double topOf(const VerticalPath& path, const CycleStates& states) {
    constexpr double kClearance = 0.5;  // of the tip's radius
    const double above =
        states.engaged->snapIn.base + (kClearance * path.instrument().system().tipRadius());
    return states.retracted
               ? std::max(above, curvePointOf(path, states.retracted->free.back()).base)
               : above;
}

/// Towards the snap-in the attraction grows with the inverse square of the distance: steps get
/// shorter.
void addFreeWay(VerticalPath& path, const CycleStates& states,
                std::vector<PixelCurvePoint>& points) {
    const double bottom = states.engaged->snapIn.before.base;
    const double way = topOf(path, states) - bottom;
    EquilibriumMemory memory;
    for (int i = 0; i < kFreePoints; ++i) {
        const double left = 1.0 - (static_cast<double>(i) / kFreePoints);
        const TipAtHeight tip = path.at(bottom + (left * left * left * way), memory);
        memory = tip.memory;
        points.push_back(curvePointOf(path, tip));
    }
}

void addBondedWay(VerticalPath& path, const Engagement& engaged,
                  std::vector<PixelCurvePoint>& points) {
    const double top = engaged.snapIn.after.base;
    const double way = top - engaged.atSetpoint.base;
    EquilibriumMemory memory = engaged.snapIn.after.memory;
    for (int i = 1; i < kBondedPoints; ++i) {
        const TipAtHeight tip =
            path.at(top - (way * static_cast<double>(i) / kBondedPoints), memory);
        memory = tip.memory;
        points.push_back(curvePointOf(path, tip));
    }
    points.push_back(curvePointOf(path, engaged.atSetpoint));
}

void takeApproach(VerticalPath& path, const CycleStates& states, PixelCurve& curve) {
    const FoundJump& snapIn = states.engaged->snapIn;
    path.goDown();
    addFreeWay(path, states, curve.approach);
    if (snapIn.jumps()) {
        const auto [before, after] = sidesOf(path, snapIn);
        curve.snapIn = before;
        curve.approach.insert(curve.approach.end(), {before, after});
    }
    addBondedWay(path, *states.engaged, curve.approach);
}

void takeRetract(const VerticalPath& path, const RetractCurve& states, PixelCurve& curve) {
    std::vector<PixelCurvePoint>& points = curve.retract;
    for (const RetractPoint& point : states.bonded) {
        points.push_back(curvePointOf(path, point));
    }
    const auto [before, after] = sidesOf(path, states.pullOff);
    points.back() = before;
    // The strongest pull may lie between two steps; there the law has it.
    if (const std::optional<RetractPoint> strongest = strongestOfLaw(path, states)) {
        points.push_back(curvePointOf(path, *strongest));
        points.back().base = std::min(points.back().base, before.base);
    }
    // Near to the jump its search goes back and forth by some picometers. At the setpoint friction
    // turns while the base stands still: rounding must not put that before the end of the approach.
    std::ranges::stable_sort(points.begin() + 1, points.end(), {}, &PixelCurvePoint::base);
    if (states.pullOff.jumps()) {
        curve.pullOff = before;
        points.push_back(after);
    }
    for (const RetractPoint& point : states.free) {
        const PixelCurvePoint free = curvePointOf(path, point);
        if (free.base >= points.back().base) {
            points.push_back(free);
        }
    }
}

}  // namespace

PixelCurve pixelCurve(const MapInstrument& instrument, const Vector2& place, double setpoint) {
    VerticalPath path(instrument, place);
    const CycleStates states = runCycle(path, setpoint);
    PixelCurve curve;
    curve.values = valuesOf(states, path);
    if (states.engaged) {
        takeApproach(path, states, curve);
    }
    if (states.retracted) {
        takeRetract(path, *states.retracted, curve);
    }
    return curve;
}

}  // namespace asperity
