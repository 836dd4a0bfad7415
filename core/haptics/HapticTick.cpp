#include "core/haptics/HapticTick.h"

#include "core/haptics/SetpointApproach.h"
#include "core/probe/ForceDecoupling.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kModelSpread = 0.2;    // share of N that the model may be off
constexpr double kModelFloor = 0.1e-9;  // [N]
constexpr double kContradictionSigmas = 3.0;
constexpr double kHeldWithin = 1e-11;  // [m]: how near the commanded position the tip must be
constexpr double kStall = 10e-3;       // [s]: a longer step counts as this

bool isSolved(const TipState& model) { return model.converged && !model.locked; }

/// Known quantities of a tick, with N as the contact model has it.
/// @param staleness of the signals [rad]
DecouplingInput decouplingInput(const Scene& scene, const TickInput& input, const TickOutput& out,
                                const LeverSignals& staleness) {
    const Friction friction = scene.belief.frictionAt(out.model.closest.point);
    return {.signals = input.measurement.signals,
            .sigma = {.bending = std::hypot(scene.signalSigma.bending, staleness.bending),
                      .torsion = std::hypot(scene.signalSigma.torsion, staleness.torsion)},
            .normal = out.model.normal,
            .normalDeviation = scene.normalDeviation,
            .velocity = out.base.velocity,
            .frictionCoefficient = friction.coefficient,
            .shearStrength = friction.shearStrength,
            .contactArea = out.model.contactArea,
            .normalForceModel = out.model.normalForce,
            .normalForceSigma = kModelSpread * std::abs(out.model.normalForce) + kModelFloor};
}

/// Where there is no equilibrium, nothing is expected of the signals.
InnovationVerdict innovationVerdict(const Scene& scene, const TickInput& input,
                                    const TickOutput& out, const DecouplingInput& known,
                                    InnovationMemory& memory) {
    return isSolved(out.model) ? monitorInnovation(scene.belief.cantilever,
                                                   {.belief = known,
                                                    .modelJumped = out.model.contact.jumped,
                                                    .age = input.measurement.age,
                                                    .timeStep = input.timeStep},
                                                   memory)
                               : InnovationVerdict{};
}

/// A model that the signals contradict (it let go, the sample did not) must not outvote them: as
/// the surprise grows, its sigma grows with it and its force gives way to that of the bending.
DecouplingInput weighed(const Scene& scene, const TipState& model, DecouplingInput known) {
    const Cantilever& cantilever = scene.belief.cantilever;
    const double perForce = cantilever.bendingPerFz();
    const double measured = known.signals.bending / perForce;
    const double expected = leverSignals(cantilever, model.force).bending / perForce;
    const double spread = known.normalForceSigma;
    const double surprise = measured - expected;
    const double limit = kContradictionSigmas * std::hypot(spread, known.sigma.bending / perForce);
    const double doubt = surprise * surprise / (surprise * surprise + limit * limit);
    const double told = measured * model.normal.z();
    known.normalForceModel = model.normalForce + doubt * (told - model.normalForce);
    known.normalForceSigma = std::hypot(spread, surprise);
    return known;
}

/// @param covarianceFactor by which the signals scatter more than stated
ForceEstimate decoupled(const Scene& scene, const DecouplingInput& input, double covarianceFactor) {
    const Cantilever& cantilever = scene.belief.cantilever;
    ForceEstimate estimate = scene.model.decoupling == DecouplingModel::Planar
                                 ? planarEstimate(cantilever, input)
                                 : estimateForce(cantilever, input);
    estimate.covariance *= covarianceFactor;
    return estimate;
}

/// First-order low-pass of (estimate - model): what the sensor knows better, without its noise.
Vector3 slowCorrection(const TickInput& input, const TickOutput& out, const Vector3& previous) {
    const double cutoff = 2.0 * std::numbers::pi * input.settings.correctionBandwidth;
    const double share = -std::expm1(-cutoff * input.timeStep);
    return previous + share * (out.estimate.force - out.model.force - previous);
}

bool allFinite(const TickOutput& out) {
    return out.base.position.allFinite() && out.model.force.allFinite() && out.tip.allFinite() &&
           out.estimate.force.allFinite() && out.deviceForce.allFinite() &&
           out.estimate.kind != DecouplingCase::InvalidInput;
}

/// Returns whether age adds more to the signals' deviation than noise, or is too large to judge.
bool isStale(const Scene& scene, const TickInput& input, const LeverSignals& staleness) {
    return staleness.bending > scene.signalSigma.bending ||
           staleness.torsion > scene.signalSigma.torsion || input.measurement.age > kOldSignals;
}

/// A stall of the loop is no failure of the solver's.
double unsolvedFor(const TickInput& input, const TickOutput& out, double before) {
    return isSolved(out.model) ? 0.0 : before + std::min(input.timeStep, kStall);
}

Fault faultOf(const TickInput& input, const TickOutput& out, double unsolved) {
    if (!allFinite(out)) {
        return Fault::NotFinite;
    }
    if (!input.device.connected) {
        return Fault::DeviceLost;
    }
    if (!input.measurement.connected) {
        return input.measurement.ended ? Fault::RecordEnded : Fault::InstrumentLost;
    }
    // A script or a mouse is pushed by nothing when a force comes back.
    const bool isOver = input.device.rendersForce() && unsolved >= kMaxUnsolved;
    return isOver ? Fault::SolverFailed : Fault::None;
}

/// Where there is no equilibrium the last force of the search means nothing.
ForceRequest requestOf(const TickInput& input, const TickOutput& out, const BaseCommand& command,
                       Fault fault) {
    return {.force = isSolved(out.model) ? out.deviceForce : Vector3(Vector3::Zero()),
            .mismatch = input.settings.coupling.stiffness * command.proxy.coupling.stretch.norm(),
            .edge = command.device.edgeForce,
            .fault = fault};
}

MappingSettings mappingSettings(const TickInput& input) {
    return {.positionGain = input.settings.positionGain,
            .axes = axesOf(input.settings.deviceTurn),
            .clutched = input.clutched()};
}

/// A handle with motors may have been moved while the loop rested, and another one is elsewhere:
/// the motion up to the first tick after a start counts for nothing. Nor does one that comes back
/// elsewhere after it was lost.
MappingStep mappedDevice(const TickInput& input, const TickMemory& memory) {
    const bool restarted = input.device.rendersForce() && input.starts != memory.governor.starts;
    MappingStep step =
        mapDevice(input.settings.workspace, input.device.position, mappingSettings(input),
                  restarted ? MappingMemory{} : memory.mapping);
    step.memory.follows = step.memory.follows && input.device.connected;
    return step;
}

/// Returns what the device commanded in the last tick.
Vector3 commandedPosition(const TickMemory& memory) {
    return memory.control == PositionControl::Tip ? Vector3(memory.base + memory.compensation)
                                                  : memory.base;
}

/// Returns what the operator would feel if nothing governed it, the device's axes [N].
Vector3 wantedForce(const TickInput& input, const TickOutput& out, const BaseCommand& command,
                    const Vector3& correction) {
    const Settings& settings = input.settings;
    return forceOnDevice(mappingSettings(input),
                         settings.coupling.couples()
                             ? command.proxy.coupling.device
                             : Vector3(settings.forceGain * (out.model.force + correction)));
}

/// Returns whether a base that goes ahead by `compensation` has the tip where it was commanded: not
/// where lever, sample and friction have no stable state there.
bool holdsTip(const Scene& scene, const BaseMotion& tip, const Vector3& compensation,
              const EquilibriumMemory& memory, ClosestPointTracker& tracker) {
    EquilibriumMemory tried = memory;
    const TipState state =
        tipEquilibrium(scene.believedSurface(), scene.belief,
                       {tip.position - compensation, tip.velocity, tip.elapsed}, tried, tracker);
    return state.converged && !state.contact.jumped && !state.locked &&
           (state.tip - tip.position).norm() <= kHeldWithin;
}

/// Estimate, wanted force and flags, from the model and the signals.
void judgeSignals(const Scene& scene, const TickInput& input, const BaseCommand& command,
                  TickOutput& out, TickMemory& memory) noexcept {
    // A lost instrument gives nothing; until it is back only the model counts.
    const bool answers = input.measurement.connected;
    const LeverSignals expected = leverSignals(scene.belief.cantilever, out.model.force);
    const LeverSignals staleness = stalenessOf(expected, answers ? input.measurement.age : 0.0,
                                               input.timeStep, memory.signals);
    DecouplingInput known = decouplingInput(scene, input, out, staleness);
    if (!answers) {
        known.signals = expected;
    }
    const InnovationVerdict verdict =
        answers ? innovationVerdict(scene, input, out, known, memory.innovation)
                : InnovationVerdict{};
    known.frictionLawError = verdict.frictionLawError;
    out.estimate = decoupled(scene, weighed(scene, out.model, known), verdict.covarianceFactor);
    out.tip = out.base.position + out.estimate.deflection;
    if (answers) {
        memory.correction = slowCorrection(input, out, memory.correction);
    }
    out.deviceForce = wantedForce(input, out, command, memory.correction);
    out.flags = tickValidity(scene, out, verdict, memory.asperity);
    out.flags.set(Validity::TipNotHeld, !command.tipHeld);
    out.flags.set(Validity::StaleSignals, isStale(scene, input, staleness));
    out.flags.set(Validity::Extrapolated, input.measurement.extrapolated);
    out.flags.set(Validity::AsideOfRecord, input.measurement.aside);
}

/// Keeps what the next tick starts from, but for governor and fault.
void remember(const TickInput& input, const BaseCommand& command, const TickOutput& out,
              TickMemory& memory) noexcept {
    memory.base = out.base.position;
    memory.compensation = command.compensation;
    memory.control = input.settings.positionControl;
    memory.mapping = command.device.memory;
    memory.guide = guideAfter(input, command.guide, command.proxy.coupling.motion);
    memory.proxy = proxyAfter(input, command.proxy, out.model, memory.model, memory.correction);
    memory.started = true;
    memory.unsolved = unsolvedFor(input, out, memory.unsolved);
}

// [m]: a notice to the operator, ahead by about what a hand takes a tenth of a second for; no force
// depends on it.
constexpr double kSnapInMargin = 1e-9;
constexpr double kSliding = 0.5;  // weight of the slip direction from which it counts

/// Returns whether a gap is too wide to ask the law for the snap-in: far out of range, on a lever
/// that is hardly bent. At a fold of the attraction it is bent by half of the gap; where it is bent
/// by a twentieth, with the attraction's square law, that gap is not half as wide.
bool isFarFromSnapIn(const ContactModel& law, const ContactState& contact, double compliance) {
    constexpr double kHardlyBent = 0.05;
    const double gap = -contact.indentation;
    return gap > 2.0 * law.attractionRange() + kSnapInMargin &&
           std::abs(compliance * contact.force) < kHardlyBent * gap;
}

/// Returns whether the base leaves the sample at its closest point.
bool isWithdrawn(const TickOutput& out) {
    return out.base.velocity.dot(out.model.closest.normal) > 0.0;
}

/// Returns whether a separate tip that does not leave the sample is about to snap in on a lever as
/// soft as this one.
bool snapsSoon(const Scene& scene, const TickOutput& out) {
    const TipState& model = out.model;
    const ContactState& contact = model.contact;
    if (contact.branch != ContactBranch::Far || isWithdrawn(out)) {
        return false;
    }
    const double compliance =
        model.closest.normal.dot(scene.belief.cantilever.compliance() * model.closest.normal);
    if (isFarFromSnapIn(scene.belief.contact, contact, compliance)) {
        return false;
    }
    const ContactModel law = contactModelAt(scene, model);
    const double jumpIn = law.jumpInApproach(compliance);
    const double now = contact.indentation + (compliance * contact.force);
    return jumpIn - now < kSnapInMargin && law.pullOffApproach(compliance) < jumpIn;
}

}  // namespace

BaseCommand commandBase(const Scene& scene, const TickInput& input, const TickMemory& memory,
                        ClosestPointTracker& tracker) noexcept {
    const Settings& settings = input.settings;
    const bool tipControl = settings.positionControl == PositionControl::Tip;
    BaseCommand command;
    command.base.position =
        settings.positionGain * (axesOf(settings.deviceTurn) * input.device.position);
    command.device = mappedDevice(input, memory);
    command.proxy.forceGain = settings.forceGain;
    if (memory.started) {
        command.guide = stepGuide(input, commandedPosition(memory), memory.guide);
        command.proxy = moveProxy(input, command.device.motion, command.guide, memory.proxy);
        const Vector3 step = settings.positionGain * command.proxy.coupling.motion;
        command.base = {memory.base + step, step / input.timeStep, input.timeStep};
    }
    if (!tipControl) {
        return command;
    }
    const bool controlled = memory.control == PositionControl::Tip;
    command.compensation = controlled ? memory.compensation : memory.model.deflection;
    const BaseMotion tip{memory.started ? Vector3(command.base.position + command.compensation)
                                        : command.base.position,
                         command.base.velocity, command.base.elapsed};
    const TipState held =
        heldTip(scene.believedSurface(), scene.belief, tip, memory.model, tracker);
    const Vector3 deflection = scene.belief.cantilever.compliance() * held.force;
    command.tipHeld = held.converged && !held.contact.jumped &&
                      holdsTip(scene, tip, deflection, memory.model, tracker);
    if (command.tipHeld) {
        command.compensation = deflection;
    }
    command.base.position = tip.position - command.compensation;
    return command;
}

TickOutput tick(const Scene& scene, const TickInput& input, const BaseCommand& command,
                TickMemory& memory, ClosestPointTracker& tracker) noexcept {
    if (input.settings.rearms != memory.rearms) {
        memory.fault = Fault::None;
        memory.rearms = input.settings.rearms;
    }
    const TickMemory before = memory;
    TickOutput out;
    out.base = command.base;
    out.model =
        tipEquilibrium(scene.believedSurface(), scene.belief, out.base, memory.model, tracker);
    judgeSignals(scene, input, command, out, memory);
    remember(input, command, out, memory);
    const Fault found = faultOf(input, out, memory.unsolved);
    if (found == Fault::NotFinite) {
        memory = before;  // nothing non-finite may live on into the next tick
    }
    const ForceRequest request =
        requestOf(input, out, command, memory.fault != Fault::None ? memory.fault : found);
    const GovernedForce governed = governForce(input, request, memory.governor);
    memory.governor = governed.memory;
    memory.fault = governed.fault;
    out.deviceForce = governed.force;
    out.forceState = governed.state;
    out.fault = governed.fault;
    return out;
}

TickOutput tick(const Scene& scene, const TickInput& input, TickMemory& memory,
                ClosestPointTracker& tracker) noexcept {
    return tick(scene, input, commandBase(scene, input, memory, tracker), memory, tracker);
}

BaseCommand commandBase(const Scene& scene, const TickInput& input,
                        const TickMemory& memory) noexcept {
    ClosestPointTracker tracker;
    return commandBase(scene, input, memory, tracker);
}

TickOutput tick(const Scene& scene, const TickInput& input, const BaseCommand& command,
                TickMemory& memory) noexcept {
    ClosestPointTracker tracker;
    return tick(scene, input, command, memory, tracker);
}

TickOutput tick(const Scene& scene, const TickInput& input, TickMemory& memory) noexcept {
    ClosestPointTracker tracker;
    return tick(scene, input, memory, tracker);
}

ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                           const InnovationVerdict& verdict, AsperityMemory& memory) noexcept {
    ValidityFlags flags =
        tipValidity(scene, scene.belief, scene.description.sample.material, out.model, memory);
    flags.set(Validity::ModelContradicted, verdict.modelContradicted);
    flags.set(Validity::EstimateInconsistent, verdict.estimateInconsistent);
    flags.set(Validity::SnapInAhead, snapsSoon(scene, out));
    flags.set(Validity::Implausible, out.estimate.plausibility.excessFriction);
    // At rest friction has no direction, and a singular geometry means nothing.
    flags.set(Validity::SingularGeometry, out.estimate.kind == DecouplingCase::NearSingular &&
                                              out.model.slip.norm() > kSliding);
    return flags;
}

}  // namespace asperity
