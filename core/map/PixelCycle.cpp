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

/// Along z, just before the tip pulls off [N].
double pullOffForce(const FoundJump& pullOff) {
    const TipState& before = pullOff.before.state;
    return pullOff.exact ? -pullOff.exact->before.force * before.closest.normal.z()
                         : -before.force.z();
}

void takeRetract(const RetractCurve& curve, const VerticalPath& path, MapValues& values) {
    const double adhesion = strongestPull(path, curve);
    if (curve.pullOff.jumps()) {
        values[MapQuantity::PullOffForce] = pullOffForce(curve.pullOff);
    }
    values[MapQuantity::AdhesionForce] = adhesion;
    values[MapQuantity::SeparationWork] = separationWork(curve);
    values[MapQuantity::ApparentModulus] =
        dmtModulus(curve.bonded, adhesion, path.instrument().system().tipRadius());
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
    flags.add(instrument.validity(curve->pullOff.before.state));
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
