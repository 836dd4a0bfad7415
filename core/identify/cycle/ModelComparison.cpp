#include "core/identify/cycle/ModelComparison.h"

#include "core/Error.h"
#include "core/identify/cycle/AdhesiveFit.h"
#include "core/identify/cycle/RelaxationFit.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::size_t kSamples = 500;  ///< of a branch at most

bool isAdhesiveModel(CycleModel model) {
    return model == CycleModel::JkrOne || model == CycleModel::JkrTwo ||
           model == CycleModel::Maugis;
}

bool isTimed(CycleModel model) {
    return model == CycleModel::Relaxation || model == CycleModel::Drag ||
           model == CycleModel::RelaxationDrag;
}

int parameterCount(CycleModel model) {
    switch (model) {
    case CycleModel::Elastic:
        return 2;
    case CycleModel::JkrOne:
        return 3;
    case CycleModel::JkrTwo:
    case CycleModel::Maugis:
    case CycleModel::Relaxation:
    case CycleModel::Drag:
        return 4;
    case CycleModel::RelaxationDrag:
        return 6;
    }
    return 0;
}

/// Returns whether `wide` holds `narrow` as a special case.
bool extends(CycleModel wide, CycleModel narrow) {
    if (narrow == CycleModel::Elastic) {
        return wide != CycleModel::Elastic;
    }
    if (narrow == CycleModel::JkrOne) {
        return wide == CycleModel::JkrTwo || wide == CycleModel::Maugis;
    }
    return wide == CycleModel::RelaxationDrag &&
           (narrow == CycleModel::Relaxation || narrow == CycleModel::Drag);
}

CycleBranch reduced(const CycleBranch& branch, std::size_t from, std::size_t to) {
    const CycleBranch few = binned(branch, from, to, kSamples);
    return {few.time, few.base, few.force};
}

/// The part of the cycle about its contact and its pull-off, with few samples.
MeasuredCycle reducedCycle(const MeasuredCycle& cycle, double tipRadius) {
    const CycleEvents events = cycleEvents(cycle);
    const double end = cycle.retract.base[events.contactEnd - 1];
    const double top = cycle.approach.base.back();
    const double begin =
        std::min(windowBegin(cycle, events, tipRadius), end - (0.25 * (top - end)));
    const auto& down = cycle.approach.base;
    const auto& up = cycle.retract.base;
    const auto first =
        std::find_if(down.begin(), down.end(), [&](double base) { return base >= begin; });
    const auto last = std::find_if(up.begin(), up.end(), [&](double base) { return base < begin; });
    const auto from = static_cast<std::size_t>(first - down.begin());
    const auto to = static_cast<std::size_t>(last - up.begin());
    MeasuredCycle few;
    few.approach = reduced(cycle.approach, from, down.size());
    few.dwell = reduced(cycle.dwell, 0, cycle.dwell.size());
    few.retract = reduced(cycle.retract, 0, to);
    few.stiffness = cycle.stiffness;
    const double averaged =
        static_cast<double>(down.size() - from) / static_cast<double>(few.approach.size());
    few.noise = cycle.noise / std::sqrt(averaged);
    return few;
}

/// Residuals of both branches, without the samples by a jump.
struct BranchMisses {
    std::vector<double> approach;
    std::vector<double> retract;
};

double rmsOf(const std::vector<double>& misses) {
    double sum = 0.0;
    for (const double miss : misses) {
        sum += miss * miss;
    }
    return std::sqrt(sum / static_cast<double>(misses.size()));
}

std::vector<double> joined(const BranchMisses& misses) {
    std::vector<double> all = misses.approach;
    all.insert(all.end(), misses.retract.begin(), misses.retract.end());
    return all;
}

/// A reduced cycle and the fits to it.
class Comparison {
public:
    Comparison(const MeasuredCycle& cycle, const ComparisonOptions& options)
        : options_(options)
        , cycle_(reducedCycle(cycle, options.tipRadius))
        , events_(cycleEvents(cycle_))
        , range_(cycle_.forceRange())
        , timed_(!cycle.approach.time.empty() && !cycle.retract.time.empty()) {}

    [[nodiscard]] bool carries(CycleModel model) const {
        return isTimed(model) ? timed_ : !isAdhesiveModel(model) || events_.attracts;
    }
    [[nodiscard]] ComparedModel compared(CycleModel model, BranchMisses& misses) const;

private:
    struct Fitted {
        BranchMisses misses;
        std::vector<std::string> notIdentified;
    };
    [[nodiscard]] Fitted fitted(CycleModel model, FittedBranch branch) const;
    [[nodiscard]] Fitted quasiStatic(CycleModel model, FittedBranch branch) const;
    [[nodiscard]] Fitted withTime(CycleModel model, FittedBranch branch) const;
    [[nodiscard]] SimulatedCycle bondedForces(const AdhesiveCycle& model) const;
    [[nodiscard]] BranchMisses missesOf(const SimulatedCycle& simulation) const;

    const ComparisonOptions& options_;
    MeasuredCycle cycle_;
    CycleEvents events_;
    double range_;
    bool timed_;
};

std::vector<double> branchMisses(const CycleBranch& branch, const std::vector<double>& forces,
                                 const std::optional<MeasuredJump>& jump, double range) {
    constexpr std::size_t kAround = 2;  // samples
    std::vector<double> misses;
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const bool jumps = jump && i + kAround >= jump->before && i <= jump->after + kAround;
        if (!jumps) {
            misses.push_back((forces[i] - branch.force[i]) / range);
        }
    }
    return misses;
}

BranchMisses Comparison::missesOf(const SimulatedCycle& simulation) const {
    return {branchMisses(cycle_.approach, simulation.approach, events_.snapIn, range_),
            branchMisses(cycle_.retract, simulation.retract, events_.pullOff, range_)};
}

/// Forces where the measured tip is in contact, none elsewhere: a jump that is simulated a sample
/// too early or too late decides nothing.
SimulatedCycle Comparison::bondedForces(const AdhesiveCycle& model) const {
    SimulatedCycle forces{std::vector<double>(cycle_.approach.size(), 0.0),
                          {},
                          std::vector<double>(cycle_.retract.size(), 0.0)};
    ContactMemory memory = model.bonded();
    for (std::size_t i = events_.contactBegin; i < cycle_.approach.size(); ++i) {
        forces.approach[i] = model.bondedForce(cycle_.approach.base[i], memory);
    }
    for (const double base : cycle_.dwell.base) {
        (void)model.bondedForce(base, memory);
    }
    for (std::size_t i = 0; i < events_.contactEnd; ++i) {
        forces.retract[i] = model.bondedForce(cycle_.retract.base[i], memory);
    }
    return forces;
}

Comparison::Fitted Comparison::quasiStatic(CycleModel model, FittedBranch branch) const {
    AdhesiveFitOptions options;
    const bool sphere = options_.sphere;
    options.law = model == CycleModel::Elastic ? (sphere ? ContactLaw::Sneddon : ContactLaw::Hertz)
                  : model == CycleModel::Maugis
                      ? (sphere ? ContactLaw::SphereMaugis : ContactLaw::Maugis)
                      : (sphere ? ContactLaw::SphereJkr : ContactLaw::Jkr);
    options.tipRadius = options_.tipRadius;
    options.twoWorks = model == CycleModel::JkrTwo;
    options.branch = branch;
    options.pullOffWeight = 0.0;
    options.placeWeight = model == CycleModel::Maugis ? options.placeWeight : 0.0;
    const AdhesiveFit fit = adhesiveFit(cycle_, options);
    return {missesOf(bondedForces(AdhesiveCycle(fit.parameters))), fit.bounded.notIdentified()};
}

Comparison::Fitted Comparison::withTime(CycleModel model, FittedBranch branch) const {
    RelaxationFitOptions options;
    options.tipRadius = options_.tipRadius;
    options.sphere = options_.sphere;
    options.poissonRatio = options_.poissonRatio;
    options.relaxation = model != CycleModel::Drag;
    options.drag = model != CycleModel::Relaxation;
    options.branch = branch;
    options.forward = true;
    options.wholeCycle = true;
    const RelaxationFit fit = relaxationFit(cycle_, options);
    return {missesOf(simulated(fit, cycle_)), fit.bounded.notIdentified()};
}

Comparison::Fitted Comparison::fitted(CycleModel model, FittedBranch branch) const {
    return isTimed(model) ? withTime(model, branch) : quasiStatic(model, branch);
}

ComparedModel Comparison::compared(CycleModel model, BranchMisses& misses) const {
    ComparedModel result;
    result.model = model;
    const Fitted both = fitted(model, FittedBranch::Both);
    misses = both.misses;
    result.rms = rmsOf(joined(misses));
    result.notIdentified = both.notIdentified;
    const Fitted retract = fitted(model, FittedBranch::Retract);
    if (retract.notIdentified.empty()) {
        result.unseenApproach = rmsOf(retract.misses.approach);
    }
    const Fitted approach = fitted(model, FittedBranch::Approach);
    if (approach.notIdentified.empty()) {
        result.unseenRetract = rmsOf(approach.misses.retract);
    }
    return result;
}

/// Number of samples with errors of their own.
double independent(const std::vector<double>& misses) {
    const Eigen::Map<const Eigen::VectorXd> all(misses.data(),
                                                static_cast<Eigen::Index>(misses.size()));
    return static_cast<double>(misses.size()) / autocorrelationFactor(all);
}

/// The best, or its special case where that is hardly worse: chance alone makes an addition look
/// better that often.
const ComparedModel& simplestOfTheBest(const std::vector<ComparedModel>& ranked) {
    constexpr double kHardly = 6.0;
    for (const ComparedModel& model : ranked) {
        if (model.criterion < kHardly && extends(ranked.front().model, model.model)) {
            return model;
        }
    }
    return ranked.front();
}

void decide(ModelComparison& comparison) {
    constexpr double kSignificant = 10.0;
    constexpr double kClearly = 1.5;
    const ComparedModel& best = simplestOfTheBest(comparison.ranked);
    comparison.best = best.model;
    for (const ComparedModel& other : comparison.ranked) {
        if (other.model == best.model || extends(other.model, best.model)) {
            continue;
        }
        const bool close = other.criterion - best.criterion < kSignificant;
        const bool predicts = best.unseenApproach && other.unseenApproach &&
                              *best.unseenApproach > kClearly * *other.unseenApproach;
        if (close || predicts) {
            comparison.best.reset();
            comparison.reasons.push_back(std::string(nameOf(other.model)) +
                                         (close ? " explains the cycle as well as "
                                                : " predicts an unseen branch better than ") +
                                         nameOf(best.model));
        }
    }
}

}  // namespace

ModelComparison compareModels(const MeasuredCycle& cycle, const ComparisonOptions& options) {
    const Comparison comparison(cycle, options);
    ModelComparison result;
    std::vector<BranchMisses> misses;
    for (const auto& row : kEnumTable<CycleModel>) {
        if (!comparison.carries(row.value)) {
            result.reasons.push_back(
                std::string(row.name) + " was not compared: " +
                (isTimed(row.value) ? "the curve has no times" : "the curve shows no adhesion"));
            continue;
        }
        result.ranked.push_back(comparison.compared(row.value, misses.emplace_back()));
    }
    const auto smallest =
        std::min_element(result.ranked.begin(), result.ranked.end(),
                         [](const auto& one, const auto& other) { return one.rms < other.rms; });
    const std::vector<double> rest =
        joined(misses[static_cast<std::size_t>(smallest - result.ranked.begin())]);
    const double count = independent(rest);
    result.independentSamples = count;
    for (ComparedModel& model : result.ranked) {
        model.criterion =
            (2.0 * count * std::log(model.rms)) + (parameterCount(model.model) * std::log(count));
    }
    std::sort(result.ranked.begin(), result.ranked.end(),
              [](const auto& one, const auto& other) { return one.criterion < other.criterion; });
    const double least = result.ranked.front().criterion;
    for (ComparedModel& model : result.ranked) {
        model.criterion -= least;
    }
    decide(result);
    return result;
}

}  // namespace asperity
