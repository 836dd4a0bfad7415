#include "core/map/PixelCycle.h"

#include "core/uncertainty/LandmarkBudgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace asperity {

namespace {

void takeSnapIn(const FoundJump& snapIn, const VerticalPath& path, MapValues& values) {
    if (!snapIn.jumps()) {
        return;
    }
    const TipState& before = snapIn.before.state;
    const double approach = snapIn.exact ? snapIn.exact->basePosition
                                         : before.contact.indentation +
                                               (path.compliance(before) * before.contact.force);
    values[MapQuantity::SnapInDistance] = 0.0 - approach;  // no -0
}

void takeSetpoint(const TipAtHeight& tip, const VerticalPath& path, MapValues& values) {
    const TipState& state = tip.state;
    const Vector3& normal = state.closest.normal;
    values[MapQuantity::Height] = path.recordedHeight(tip);
    values[MapQuantity::Indentation] = state.contact.indentation;
    values[MapQuantity::ContactRadius] = std::sqrt(state.contactArea / std::numbers::pi);
    values[MapQuantity::Stiffness] = state.contact.stiffness;
    values[MapQuantity::LateralForce] = std::hypot(state.force.x(), state.force.y());
    values[MapQuantity::NormalAngle] = std::atan2(std::hypot(normal.x(), normal.y()), normal.z());
}

void takeRetract(const RetractCurve& curve, const VerticalPath& path, MapValues& values) {
    const double adhesion = strongestPull(path, curve);
    const FoundJump& pullOff = curve.pullOff;
    const double pull = -pullOff.forceBefore();
    // What is no equilibrium has no force to read.
    if (pullOff.jumps() && pullOff.before.state.converged) {
        values[MapQuantity::PullOffForce] = pull;
    }
    values[MapQuantity::AdhesionForce] = adhesion;
    values[MapQuantity::SeparationWork] = separationWork(curve);
    values[MapQuantity::ApparentModulus] =
        dmtModulus(curve.bonded, adhesion, path.instrument().system().tipRadius());
}

/// The law's own energies of its jumps, without the error of steps; of several points, or where the
/// law does not have the jump, the area of the loop.
std::optional<double> dissipatedIn(VerticalPath& path, const Engagement& engaged,
                                   const RetractCurve& curve) {
    const FoundJump& snapIn = engaged.snapIn;
    const FoundJump& pullOff = curve.pullOff;
    const bool isOfLaw =
        snapIn.ofOnePoint && pullOff.ofOnePoint && engaged.atSetpoint.state.points == 1;
    return isOfLaw ? snapIn.energyLost() + pullOff.energyLost() : loopEnergy(path, engaged);
}

// At the foot of a particle, where contacts take turns in a loop of 2 pm, 24 leave an error of all
// of its 0.3 zJ, 48 one of 0.3 %.
constexpr int kBondedSteps = 48;
constexpr int kFreeSteps = 6;

/// A state of the tip by the height of the base.
struct BasePoint {
    double base = 0.0;   ///< [m]
    double force = 0.0;  ///< along z [N]
};

/// Area under a line of points in rising order [J].
double areaUnder(const std::vector<BasePoint>& points) {
    double area = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        area +=
            0.5 * (points[i - 1].force + points[i].force) * (points[i].base - points[i - 1].base);
    }
    return area;
}

void add(const TipAtHeight& tip, std::vector<BasePoint>& points) {
    if (tip.state.converged) {
        points.push_back({tip.base, tip.force()});
    }
}

/// Heights of the bonded way, the same down and up: where the states are, too, the area is none.
std::vector<double> bondedHeights(const Engagement& engaged) {
    std::vector<double> heights;
    for (int i = 0; i <= kBondedSteps; ++i) {
        heights.push_back(std::lerp(engaged.atSetpoint.base, engaged.snapIn.base,
                                    static_cast<double>(i) / kBondedSteps));
    }
    return heights;
}

/// Bonded, from the snap-in down to the setpoint's height; points in rising order.
/// @return the state there
TipAtHeight goDown(VerticalPath& path, const Engagement& engaged, std::vector<BasePoint>& points) {
    TipAtHeight tip = engaged.snapIn.after;
    std::vector<double> heights = bondedHeights(engaged);
    std::ranges::reverse(heights);
    for (const double height : heights) {
        tip = path.at(height, tip.memory);
        add(tip, points);
    }
    std::ranges::reverse(points);
    return tip;
}

/// From there up to the snap-in's height or the pull-off, whichever is first, and on to the
/// pull-off.
std::optional<FoundJump> goUp(VerticalPath& path, const Engagement& engaged, TipAtHeight tip,
                              std::vector<BasePoint>& points) {
    const double step = heightToPullOff(path, tip) / kBondedSteps;
    for (const double height : bondedHeights(engaged)) {
        TipAtHeight next = path.at(height, tip.memory);
        if (!next.isBonded()) {
            break;
        }
        tip = std::move(next);
        add(tip, points);
    }
    std::vector<TipAtHeight> passed;
    std::optional<FoundJump> pullOff = findPullOff(path, std::move(tip), step, passed);
    if (pullOff) {
        for (const TipAtHeight& bonded : passed) {
            add(bonded, points);
        }
        points.push_back({pullOff->base, pullOff->forceBefore()});
        // Near to the jump its search goes back and forth by some picometers.
        std::ranges::stable_sort(points, {}, &BasePoint::base);
    }
    return pullOff;
}

/// Free, from the snap-in up to the pull-off. Near the snap-in the attraction changes most: steps
/// are shorter there.
void addFreeWay(VerticalPath& path, const FoundJump& snapIn, double top,
                std::vector<BasePoint>& points) {
    points.push_back({snapIn.base, snapIn.forceBefore()});
    EquilibriumMemory memory = snapIn.before.memory;
    for (int i = 1; i <= kFreeSteps; ++i) {
        const double share = static_cast<double>(i) / kFreeSteps;
        const TipAtHeight tip = path.at(std::lerp(snapIn.base, top, share * share), memory);
        memory = tip.memory;
        points.push_back({tip.base, tip.force()});
    }
}

/// A quantity, the landmark of the law that it reads, and where its deviation goes.
struct DeviationRow {
    MapQuantity quantity;
    Landmark landmark;
    MapQuantity deviation;
};

constexpr auto kDeviations = std::to_array<DeviationRow>(
    {{MapQuantity::AdhesionForce, Landmark::AdhesionForce, MapQuantity::AdhesionForceDeviation},
     {MapQuantity::SeparationWork, Landmark::SeparationWork, MapQuantity::SeparationWorkDeviation},
     {MapQuantity::Indentation, Landmark::Indentation, MapQuantity::IndentationDeviation},
     {MapQuantity::Stiffness, Landmark::Stiffness, MapQuantity::StiffnessDeviation}});

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
    // turns while the base is at rest: rounding must not put that before the end of the approach.
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

CycleStates runCycle(VerticalPath& path, double setpoint) {
    CycleStates states{
        .engaged = engage(path, setpoint), .retracted = std::nullopt, .dissipated = std::nullopt};
    if (states.engaged && states.engaged->atSetpoint.state.converged) {
        states.retracted = retract(path, states.engaged->atSetpoint);
    }
    if (states.retracted) {
        states.dissipated = dissipatedIn(path, *states.engaged, *states.retracted);
    }
    return states;
}

MapValues valuesOf(const CycleStates& states, const VerticalPath& path) {
    const MapInstrument& instrument = path.instrument();
    MapValues values;
    ValidityFlags flags;
    flags.set(Validity::NotInEquilibrium, !states.retracted);
    if (states.engaged) {
        takeSnapIn(states.engaged->snapIn, path, values);
        if (states.engaged->atSetpoint.state.converged) {
            takeSetpoint(states.engaged->atSetpoint, path, values);
        }
        flags.add(instrument.validity(states.engaged->atSetpoint.state));
    }
    if (states.retracted) {
        const FoundJump& pullOff = states.retracted->pullOff;
        takeRetract(*states.retracted, path, values);
        flags.add(instrument.validity(pullOff.before.state));
    }
    if (states.dissipated) {
        values[MapQuantity::DissipatedEnergy] = *states.dissipated;
    }
    values[MapQuantity::Validity] = static_cast<double>(flags.bits());
    values[MapQuantity::Iterations] = path.solved();
    return values;
}

MapValues pixelCycle(const MapInstrument& instrument, const Vector2& position, double setpoint) {
    VerticalPath path(instrument, position);
    return valuesOf(runCycle(path, setpoint), path);
}

std::optional<double> loopEnergy(VerticalPath& path, const Engagement& engaged) {
    path.stop();
    std::vector<BasePoint> down;
    std::vector<BasePoint> up;
    const std::optional<FoundJump> pullOff = goUp(path, engaged, goDown(path, engaged, down), up);
    if (!pullOff) {
        return std::nullopt;
    }
    addFreeWay(path, engaged.snapIn, pullOff->base, down);
    return areaUnder(down) - areaUnder(up);
}

bool isDeviation(MapQuantity quantity) noexcept {
    return std::ranges::find(kDeviations, quantity, &DeviationRow::deviation) != kDeviations.end();
}

bool hasDeviations(const MapPlan& plan) {
    return std::ranges::any_of(plan.quantities, isDeviation);
}

void takeDeviations(const Scene& scene, const TipState& setpoint, MapValues& values) {
    const LandmarkBudgets budgets = budgetsAt(scene, setpoint, setpoint.normalForce);
    for (const DeviationRow& row : kDeviations) {
        // Not a number where the law has no such landmark or the tip has several contacts.
        values[row.deviation] =
            budgetOf(budgets, row.landmark).of(values[row.quantity], 0.0).modelAboutValue();
    }
}

PixelCurve pixelCurve(const MapInstrument& instrument, const Vector2& position, double setpoint) {
    VerticalPath path(instrument, position);
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
