#include "core/map/PixelCycle.h"

#include "core/map/DmtFit.h"
#include "core/map/LoopEnergy.h"

#include <cmath>
#include <numbers>

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
    values[MapQuantity::SnapInDistance] = -approach;
}

void takeSetpoint(const TipAtHeight& tip, const VerticalPath& path, MapValues& values) {
    const TipState& state = tip.state;
    const Vector3& normal = state.normal;
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
    // A tip that jumps from one wall to another is no state to read a force from.
    if (pullOff.jumps() && (pull > 0.0 || pullOff.before.state.converged)) {
        values[MapQuantity::PullOffForce] = pull;
    }
    values[MapQuantity::AdhesionForce] = adhesion;
    values[MapQuantity::SeparationWork] = separationWork(curve);
    values[MapQuantity::ApparentModulus] =
        dmtModulus(curve.bonded, adhesion, path.instrument().system().tipRadius());
}

/// The law's own energies of its jumps, without the error of steps; else the area of the loop.
double dissipatedIn(VerticalPath& path, const FoundJump& snapIn, const RetractCurve& curve) {
    const FoundJump& pullOff = curve.pullOff;
    return snapIn.ofOnePoint && pullOff.ofOnePoint ? snapIn.energyLost() + pullOff.energyLost()
                                                   : loopEnergy(path, snapIn, curve);
}

/// What the pull-off does not hold for. So near to it an equilibrium may take more steps than there
/// are, which does not matter where the law knows the jump.
ValidityFlags pullOffValidity(const MapInstrument& instrument, const FoundJump& pullOff) {
    TipState before = pullOff.before.state;
    before.converged |= pullOff.exact.has_value();
    return instrument.validity(before);
}

}  // namespace

CycleStates runCycle(VerticalPath& path, double setpoint) {
    CycleStates states{
        .engaged = engage(path, setpoint), .retracted = std::nullopt, .dissipated = 0.0};
    if (states.engaged) {
        states.retracted = retract(path, states.engaged->atSetpoint);
    }
    if (states.retracted) {
        states.dissipated = dissipatedIn(path, states.engaged->snapIn, *states.retracted);
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
        takeSetpoint(states.engaged->atSetpoint, path, values);
        flags.add(instrument.validity(states.engaged->atSetpoint.state));
    }
    if (states.retracted) {
        const FoundJump& pullOff = states.retracted->pullOff;
        takeRetract(*states.retracted, path, values);
        values[MapQuantity::DissipatedEnergy] = states.dissipated;
        flags.add(pullOffValidity(instrument, pullOff));
    }
    values[MapQuantity::Validity] = flags.bits();
    values[MapQuantity::Iterations] = path.solved();
    return values;
}

MapValues pixelCycle(const MapInstrument& instrument, const Vector2& place, double setpoint) {
    VerticalPath path(instrument, place);
    return valuesOf(runCycle(path, setpoint), path);
}

}  // namespace asperity
