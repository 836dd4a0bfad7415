#include "core/identify/cycle/AdhesiveCycle.h"

#include "core/contact/laws/ForceCurve.h"

namespace asperity {

namespace {

ContactPair approachPair(const AdhesiveParameters& parameters) noexcept {
    return {.tipRadius = parameters.tipRadius,
            .reducedModulus = parameters.reducedModulus,
            .workOfAdhesion = isAdhesive(parameters.law) ? parameters.approachWork : 0.0};
}

ContactModel approachModel(const AdhesiveParameters& parameters) {
    ContactOptions options;
    options.solver = SolverSetting::Newton;
    if (parameters.cohesiveRange > 0.0) {
        options.cohesiveStress = parameters.approachWork / parameters.cohesiveRange;
    }
    return {parameters.law, approachPair(parameters), options};
}

}  // namespace

bool isWithinLaw(const AdhesiveParameters& parameters) noexcept {
    const double range = parameters.cohesiveRange > 0.0 ? parameters.cohesiveRange : kCohesiveRange;
    const auto holds = [&](double work) {
        ContactPair pair = approachPair(parameters);
        pair.workOfAdhesion = isAdhesive(parameters.law) ? work : 0.0;
        return checkPair(pair, pair.workOfAdhesion / range) == ContactStatus::Solved;
    };
    return holds(parameters.approachWork) && holds(parameters.retractWork);
}

AdhesiveCycle::AdhesiveCycle(const AdhesiveParameters& parameters)
    : parameters_(parameters)
    , compliance_(1.0 / parameters.lever.trueStiffness())
    , bonding_(approachModel(parameters)) {
    if (isJkr(parameters.law)) {
        two_.emplace(parameters.law, approachPair(parameters), parameters.retractWork);
    }
    lastForce_ = opening().lastBonded(compliance_).force;
}

const ContactModel& AdhesiveCycle::opening() const noexcept {
    return two_ ? two_->shrinking() : bonding_;
}

ContactState AdhesiveCycle::next(double base, AdhesiveMemory& memory) const noexcept {
    const double approach = base - parameters_.contactPoint;
    if (two_) {
        return two_->equilibrium(approach, compliance_, memory.two);
    }
    const ContactState state = bonding_.equilibrium(approach, compliance_, memory.contact);
    memory.contact = state.memory();
    return state;
}

double AdhesiveCycle::force(double base, AdhesiveMemory& memory) const noexcept {
    return next(base, memory).force * parameters_.lever.forceFactor();
}

double AdhesiveCycle::bondedForce(double base, AdhesiveMemory& memory) const noexcept {
    AdhesiveMemory kept = memory;
    const ContactState state = next(base, memory);
    if (state.branch == ContactBranch::Bonded || !isAdhesive(parameters_.law)) {
        return state.force * parameters_.lever.forceFactor();
    }
    memory = kept;
    return lastForce_ * parameters_.lever.forceFactor();
}

AdhesiveMemory AdhesiveCycle::bonded() const noexcept {
    return {.contact = kBondedMemory, .two = {ContactBranch::Bonded, 0.0}};
}

std::optional<double> AdhesiveCycle::snapIn() const noexcept {
    if (bonding_.pair().workOfAdhesion < kMinAdhesion) {
        return std::nullopt;
    }
    return parameters_.contactPoint + bonding_.jumpInApproach(compliance_);
}

std::optional<double> AdhesiveCycle::pullOff() const noexcept {
    if (opening().pair().workOfAdhesion < kMinAdhesion) {
        return std::nullopt;
    }
    return parameters_.contactPoint + opening().pullOffApproach(compliance_);
}

double AdhesiveCycle::pullOffForce() const noexcept {
    return lastForce_ * parameters_.lever.forceFactor();
}

double AdhesiveCycle::lowestForce() const noexcept {
    const auto strongest = strongestPullOf(opening(), compliance_);
    return strongest ? strongest->state.force * parameters_.lever.forceFactor() : 0.0;
}

SimulatedCycle simulated(const AdhesiveCycle& model, const MeasuredCycle& cycle) {
    AdhesiveMemory memory;
    const auto follow = [&](const CycleBranch& branch) {
        std::vector<double> forces;
        forces.reserve(branch.size());
        for (const double base : branch.base) {
            forces.push_back(model.force(base, memory));
        }
        return forces;
    };
    SimulatedCycle result;
    result.approach = follow(cycle.approach);
    result.dwell = follow(cycle.dwell);
    result.retract = follow(cycle.retract);
    return result;
}

}  // namespace asperity
