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
    values[MapQuantity::Validity] = flags.bits();
    values[MapQuantity::Iterations] = path.solved();
    return values;
}

MapValues pixelCycle(const MapInstrument& instrument, const Vector2& place, double setpoint) {
    VerticalPath path(instrument, place);
    return valuesOf(runCycle(path, setpoint), path);
}

}  // namespace asperity
