#include "core/identify/cycle/CycleResiduals.h"

#include "core/Error.h"
#include "core/identify/cycle/MeasuredCycle.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Sum of squares over some samples.
struct SquareSum {
    double sum = 0.0;
    std::size_t count = 0;

    void add(double value) {
        sum += value * value;
        ++count;
    }
    void add(const SquareSum& other) {
        sum += other.sum;
        count += other.count;
    }
    [[nodiscard]] double rms() const {
        return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
    }
};

struct BranchSquares {
    SquareSum contact;
    SquareSum quiet;  ///< all but the samples by the jump
    SquareSum all;
};

BranchSquares branchSquares(const CycleBranch& branch, const std::vector<double>& forces,
                            const std::optional<MeasuredJump>& jump, double margin,
                            std::size_t contactFrom, std::size_t contactTo) {
    if (forces.size() != branch.size()) {
        throw Error("a simulated branch needs a force for each measured sample");
    }
    BranchSquares squares;
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const double miss = forces[i] - branch.force[i];
        squares.all.add(miss);
        if (jump && std::abs(branch.base[i] - jump->base) <= margin) {
            continue;
        }
        squares.quiet.add(miss);
        if (i >= contactFrom && i < contactTo) {
            squares.contact.add(miss);
        }
    }
    return squares;
}

BranchSquares approachSquares(const MeasuredCycle& cycle, const CycleEvents& events,
                              const SimulatedCycle& simulation) {
    return branchSquares(cycle.approach, simulation.approach, events.snapIn, kSnapInMargin,
                         events.contactBegin, cycle.approach.size());
}

BranchSquares retractSquares(const MeasuredCycle& cycle, const CycleEvents& events,
                             const SimulatedCycle& simulation) {
    return branchSquares(cycle.retract, simulation.retract, events.pullOff, kPullOffMargin, 0,
                         events.contactEnd);
}

double workOfBase(const CycleBranch& branch) {
    double work = 0.0;
    for (std::size_t i = 1; i < branch.size(); ++i) {
        work +=
            0.5 * (branch.force[i] + branch.force[i - 1]) * (branch.base[i] - branch.base[i - 1]);
    }
    return work;
}

double forceAtBase(const CycleBranch& branch, double base) {
    for (std::size_t i = 1; i < branch.size(); ++i) {
        const double step = branch.base[i] - branch.base[i - 1];
        if (branch.base[i] >= base && step > 0.0) {
            const double share = std::clamp((base - branch.base[i - 1]) / step, 0.0, 1.0);
            return branch.force[i - 1] + (share * (branch.force[i] - branch.force[i - 1]));
        }
    }
    return branch.force.back();
}

}  // namespace

CycleResiduals cycleResiduals(const MeasuredCycle& cycle, const CycleEvents& events,
                              const SimulatedCycle& fitted, const SimulatedCycle& forward) {
    const double range = cycle.forceRange();
    const BranchSquares approach = approachSquares(cycle, events, fitted);
    const BranchSquares retract = retractSquares(cycle, events, fitted);
    const auto both = [&](SquareSum sum, const SquareSum& other) {
        sum.add(other);
        return sum.rms() / range;
    };
    return {.approachContact = approach.contact.rms() / range,
            .retractContact = retract.contact.rms() / range,
            .contact = both(approach.contact, retract.contact),
            .cycle = both(approach.quiet, retract.quiet),
            .cycleWithJumps = both(approach.all, retract.all),
            .forwardCycle = both(approachSquares(cycle, events, forward).quiet,
                                 retractSquares(cycle, events, forward).quiet),
            .noise = cycle.noise / range};
}

CycleFigures cycleFigures(const MeasuredCycle& cycle, const CycleEvents& events) {
    const CycleBranch& approach = cycle.approach;
    const CycleBranch& retract = cycle.retract;
    CycleFigures figures;
    figures.lowestForce = *std::min_element(retract.force.begin(), retract.force.end());
    figures.approachSlope =
        contactSlope(binned(approach, events.contactBegin, approach.size(), approach.size()));
    figures.retractSlope = contactSlope(binned(retract, 0, events.contactEnd, retract.size()));
    figures.loopEnergy = workOfBase(approach) + workOfBase(retract);
    if (events.snapIn) {
        figures.snapInBase = events.snapIn->base;
        figures.snapInForce = forceAtBase(approach, events.snapIn->base + kSnapInMargin);
    }
    if (events.pullOff) {
        figures.pullOffBase = retract.base[events.pullOff->before];
    }
    return figures;
}

CycleFigures simulatedFigures(const MeasuredCycle& cycle, const CycleEvents& events,
                              const AdhesiveCycle& model, const SimulatedCycle& simulation) {
    MeasuredCycle shown = cycle;
    shown.approach.force = simulation.approach;
    shown.retract.force = simulation.retract;
    CycleFigures figures = cycleFigures(shown, events);
    figures.snapInBase = model.snapIn();
    figures.pullOffBase = model.pullOff();
    return figures;
}

}  // namespace asperity
