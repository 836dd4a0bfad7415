#include "core/map/PixelCycle.h"

#include "core/map/DmtFit.h"
#include "core/map/Engagement.h"
#include "core/map/RetractCurve.h"

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

/// What the pull-off does not hold for. So near to it an equilibrium may take more steps than there
/// are, which does not matter where the law knows the jump.
ValidityFlags pullOffValidity(const MapInstrument& instrument, const FoundJump& pullOff) {
    TipState before = pullOff.before.state;
    before.converged |= pullOff.exact.has_value();
    return instrument.validity(before);
}

/// The flags of the states that the quantities come from, after as much of a cycle as there is.
ValidityFlags cycle(VerticalPath& path, double setpoint, MapValues& values) {
    const MapInstrument& instrument = path.instrument();
    ValidityFlags flags;
    const std::optional<Engagement> engaged = engage(path, setpoint);
    if (!engaged) {
        flags.set(Validity::NotInEquilibrium, true);
        return flags;
    }
    takeSnapIn(engaged->snapIn, path, values);
    takeSetpoint(engaged->atSetpoint, path, values);
    flags.add(instrument.validity(engaged->atSetpoint.state));
    const std::optional<RetractCurve> curve = retract(path, engaged->atSetpoint);
    if (!curve) {
        flags.set(Validity::NotInEquilibrium, true);
        return flags;
    }
    takeRetract(*curve, path, values);
    values[MapQuantity::DissipatedEnergy] =
        engaged->snapIn.energyLost() + curve->pullOff.energyLost();
    flags.add(pullOffValidity(instrument, curve->pullOff));
    return flags;
}

}  // namespace

MapValues pixelCycle(const MapInstrument& instrument, const Vector2& place, double setpoint) {
    VerticalPath path(instrument, place);
    MapValues values;
    const ValidityFlags flags = cycle(path, setpoint, values);
    values[MapQuantity::Validity] = flags.bits();
    values[MapQuantity::Iterations] = path.solved();
    return values;
}

}  // namespace asperity
