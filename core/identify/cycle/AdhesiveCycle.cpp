#include "core/identify/cycle/AdhesiveCycle.h"

#include "core/contact/laws/ForceCurve.h"

namespace asperity {

namespace {

ContactPair approachPair(const AdhesiveParameters& parameters) noexcept {
    return {.tipRadius = parameters.tipRadius,
            .reducedModulus = parameters.reducedModulus,
            .workOfAdhesion = isAdhesive(parameters.law) ? parameters.approachWork : 0.0};
}

ContactModel contactModel(const AdhesiveParameters& parameters) {
    ContactOptions options;
    options.solver = SolverSetting::Newton;
    if (parameters.cohesiveRange > 0.0) {
        options.cohesiveStress = parameters.approachWork / parameters.cohesiveRange;
    }
    if (isJkr(parameters.law) && parameters.approachWork > 0.0) {
        options.adhesionRatio = parameters.retractWork / parameters.approachWork;
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
    , contact_(contactModel(parameters)) {
    if (contact_.adhesionRatio() > 1.0) {
        two_.emplace(contact_);
    }
    lastForce_ = contact_.lastBonded(compliance_).force;
}

ContactState AdhesiveCycle::next(double base, ContactMemory& memory) const noexcept {
    const double approach = base - parameters_.contactPoint;
    const ContactState state = two_ ? two_->equilibrium(approach, compliance_, memory)
                                    : contact_.equilibrium(approach, compliance_, memory);
    memory = state.memory();
    return state;
}

double AdhesiveCycle::force(double base, ContactMemory& memory) const noexcept {
    return next(base, memory).force * parameters_.lever.forceFactor();
}

double AdhesiveCycle::bondedForce(double base, ContactMemory& memory) const noexcept {
    ContactMemory kept = memory;
    const ContactState state = next(base, memory);
    if (state.branch == ContactBranch::Bonded || !isAdhesive(parameters_.law)) {
        return state.force * parameters_.lever.forceFactor();
    }
    memory = kept;
    return lastForce_ * parameters_.lever.forceFactor();
}

ContactMemory AdhesiveCycle::bonded() const noexcept {
    return two_ ? kGrowingMemory : kBondedMemory;
}

std::optional<double> AdhesiveCycle::snapIn() const noexcept {
    if (contact_.pair().workOfAdhesion < kMinAdhesion) {
        return std::nullopt;
    }
    return parameters_.contactPoint + contact_.jumpInApproach(compliance_);
}

std::optional<double> AdhesiveCycle::pullOff() const noexcept {
    if (contact_.pair().workOfAdhesion < kMinAdhesion) {
        return std::nullopt;
    }
    return parameters_.contactPoint + contact_.pullOffApproach(compliance_);
}

double AdhesiveCycle::pullOffForce() const noexcept {
    return lastForce_ * parameters_.lever.forceFactor();
}

double AdhesiveCycle::lowestForce() const noexcept {
    const auto strongest = strongestPullOf(contact_, compliance_);
    return strongest ? strongest->state.force * parameters_.lever.forceFactor() : 0.0;
}

SimulatedCycle simulated(const AdhesiveCycle& model, const MeasuredCycle& cycle) {
    ContactMemory memory;
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
