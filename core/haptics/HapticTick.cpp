#include "core/haptics/HapticTick.h"

#include "core/surface/Curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kLargeContact = 0.3;   // a/R up to which the half-space is credible
constexpr double kCurvedSample = 0.1;   // curvature times tip radius taken as flat
constexpr double kModelSpread = 0.2;    // share of N that the model may be off
constexpr double kModelFloor = 0.1e-9;  // [N]
constexpr double kContradictionSigmas = 3.0;
constexpr double kSliding = 0.5;  // weight of the slip direction from which it counts

/// What the contact model gives to the estimate, weighed against the bending signal.
struct NormalForcePrior {
    double force = 0.0;         ///< [N]
    double sigma = 0.0;         ///< [N]
    bool contradicted = false;  ///< the signal differs from the model by more than 3 sigma
};

/// A model that the signals contradict (it let go, the sample did not) must not outvote them: as
/// the surprise grows, its sigma grows with it and its force gives way to what the bending tells.
NormalForcePrior normalForcePrior(const Scene& scene, const TickInput& input,
                                  const TipState& model) {
    const Cantilever& cantilever = scene.belief.cantilever;
    const double perForce = cantilever.bendingPerFz();
    const double measured = input.measurement.signals.bending / perForce;
    const double expected = leverSignals(cantilever, model.force).bending / perForce;
    const double spread = kModelSpread * std::abs(model.contact.force) + kModelFloor;
    const double surprise = measured - expected;
    const double limit =
        kContradictionSigmas * std::hypot(spread, scene.signalSigma.bending / perForce);
    const double doubt = surprise * surprise / (surprise * surprise + limit * limit);
    const double told = measured * model.foot.normal.z();
    return {.force = model.contact.force + doubt * (told - model.contact.force),
            .sigma = std::hypot(spread, surprise),
            .contradicted = std::abs(surprise) > limit};
}

DecouplingInput decouplingInput(const Scene& scene, const TickInput& input, const TickOutput& out,
                                const NormalForcePrior& prior) {
    const double radius = out.model.contact.contactRadius;
    return {.signals = input.measurement.signals,
            .sigma = scene.signalSigma,
            .normal = out.model.foot.normal,
            .velocity = out.base.velocity,
            .frictionCoefficient = scene.belief.friction.coefficient,
            .shearStrength = scene.belief.friction.shearStrength,
            .contactArea = std::numbers::pi * radius * radius,
            .normalForceModel = prior.force,
            .normalForceSigma = prior.sigma};
}

/// Bonded to a sample so curved that the effective radius differs from the tip's by some 10 %.
bool isCurved(const Scene& scene, const TipState& model) {
    if (model.contact.branch == ContactBranch::Far) {
        return false;
    }
    const Vector3& foot = model.foot.point;
    const PrincipalCurvatures found = principalCurvatures(scene.surface.at(foot.x(), foot.y()));
    const double strongest = std::max(std::abs(found.largest), std::abs(found.smallest));
    return strongest * scene.belief.tipRadius() > kCurvedSample;
}

ValidityFlags validity(const Scene& scene, const TickOutput& out, bool contradicted) {
    const Vector3& foot = out.model.foot.point;
    ValidityFlags flags;
    flags.set(Validity::LargeContact,
              out.model.contact.contactRadius > kLargeContact * scene.belief.tipRadius());
    flags.set(Validity::OutsideScan, !out.model.foot.insideScan);
    flags.set(Validity::FilledPixel, !scene.surface.isMeasured(foot.x(), foot.y()));
    flags.set(Validity::FootNotFound, !out.model.foot.converged);
    flags.set(Validity::NotInEquilibrium, !out.model.converged || !out.model.contact.solved);
    flags.set(Validity::FrictionLock, out.model.locked);
    flags.set(Validity::ModelContradicted, contradicted);
    flags.set(Validity::CurvedSample, isCurved(scene, out.model));
    // At rest friction has no direction, and that the geometry is singular tells nothing.
    flags.set(Validity::SingularGeometry, out.estimate.kind == DecouplingCase::NearSingular &&
                                              out.model.slip.norm() > kSliding);
    return flags;
}

/// First-order low-pass of (estimate - model): what the sensor knows better, without its noise.
Vector3 slowCorrection(const TickInput& input, const TickOutput& out, const Vector3& previous) {
    const double cutoff = 2.0 * std::numbers::pi * input.settings.correctionBandwidth;
    const double share = -std::expm1(-cutoff * input.timeStep);
    return previous + share * (out.estimate.force - out.model.force - previous);
}

bool allFinite(const TickOutput& out) {
    return out.base.position.allFinite() && out.model.force.allFinite() && out.tip.allFinite() &&
           out.estimate.force.allFinite() && out.handForce.allFinite() &&
           out.estimate.kind != DecouplingCase::InvalidInput;
}

}  // namespace

BaseMotion commandBase(const HandState& hand, const Settings& settings, double timeStep,
                       const TickMemory& memory) noexcept {
    if (!memory.started) {
        return {settings.positionGain * hand.position, Vector3::Zero()};
    }
    const Vector3 step = settings.positionGain * (hand.position - memory.hand);
    return {memory.base + step, step / timeStep};
}

TickOutput tick(const Scene& scene, const TickInput& input, TickMemory& memory) noexcept {
    if (input.settings.rearms != memory.rearms) {
        memory.fault = Fault::None;
        memory.rearms = input.settings.rearms;
    }
    const TickMemory before = memory;
    TickOutput out;
    out.base = commandBase(input.hand, input.settings, input.timeStep, memory);
    out.model = tipEquilibrium(scene.surface, scene.belief, out.base, memory.model);
    const NormalForcePrior prior = normalForcePrior(scene, input, out.model);
    out.estimate =
        estimateForce(scene.belief.cantilever, decouplingInput(scene, input, out, prior));
    out.tip = out.base.position + scene.belief.cantilever.compliance() * out.estimate.force;
    memory.correction = slowCorrection(input, out, memory.correction);
    out.handForce = input.settings.forceGain * (out.model.force + memory.correction);
    out.flags = validity(scene, out, prior.contradicted);
    memory.base = out.base.position;
    memory.hand = input.hand.position;
    memory.started = true;
    if (!allFinite(out)) {
        memory = before;  // nothing non-finite may live on into the next tick
        memory.fault = Fault::NotFinite;
    } else if (!input.hand.connected) {
        memory.fault = Fault::DeviceLost;
    }
    out.fault = memory.fault;
    if (out.fault != Fault::None || !input.settings.forcesOn) {
        out.handForce.setZero();
    }
    return out;
}

}  // namespace asperity
