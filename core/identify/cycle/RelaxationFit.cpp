#include "core/identify/cycle/RelaxationFit.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

using Eigen::Index;

void append(CycleBranch& all, const CycleBranch& more) {
    all.time.insert(all.time.end(), more.time.begin(), more.time.end());
    all.base.insert(all.base.end(), more.base.begin(), more.base.end());
    all.force.insert(all.force.end(), more.force.begin(), more.force.end());
}

/// Base position less bending, the indentation but for the contact point.
std::vector<double> tipPositions(const CycleBranch& samples, double stiffness) {
    std::vector<double> positions(samples.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        positions[i] = samples.base[i] - (samples.force[i] / stiffness);
    }
    return positions;
}

/// One fit from one start.
class RelaxationProblem {
public:
    RelaxationProblem(const RelaxationFitOptions& options, const RelaxationFit& given,
                      double forceRange)
        : options_(options)
        , stiffness_(given.stiffness)
        , times_(given.samples.time)
        , bases_(given.samples.base)
        , forces_(given.samples.force)
        , positions_(tipPositions(given.samples, given.stiffness))
        , from_(options.branch == FittedBranch::Retract ? given.turn : 0)
        , to_(options.branch == FittedBranch::Approach ? given.turn : times_.size())
        , range_(forceRange) {}

    [[nodiscard]] RelaxingParameters elastic(double modulus, double contactPoint) const;
    /// @param forward with the force over the base motion alone
    [[nodiscard]] BoundedFit solve(const RelaxingParameters& start, bool forward) const;
    [[nodiscard]] RelaxingParameters with(RelaxingParameters parameters,
                                          const std::vector<double>& values) const;
    [[nodiscard]] std::vector<double> fitted(const RelaxingParameters& parameters) const;
    [[nodiscard]] std::vector<double> forward(const RelaxingParameters& parameters) const {
        return simulatedForces(parameters, stiffness_, times_, bases_);
    }
    [[nodiscard]] double deepest(double contactPoint) const {
        return *std::max_element(positions_.begin(), positions_.end()) - contactPoint;
    }
    [[nodiscard]] double squares(const RelaxingParameters& parameters) const;
    [[nodiscard]] double duration() const { return times_.back() - times_.front(); }
    [[nodiscard]] double fastest() const;

private:
    [[nodiscard]] std::vector<FreeParameter> freeParameters(const RelaxingParameters& start) const;

    const RelaxationFitOptions& options_;
    double stiffness_;  ///< of the lever [N/m]
    const std::vector<double>& times_;
    const std::vector<double>& bases_;
    const std::vector<double>& forces_;
    std::vector<double> positions_;
    std::size_t from_;  ///< first sample that the fit sees
    std::size_t to_;    ///< and the first beyond
    double range_;      ///< of the force [N]
};

double RelaxationProblem::fastest() const {
    double speed = 0.0;
    for (std::size_t i = 1; i < times_.size(); ++i) {
        speed = std::max(speed,
                         std::abs(positions_[i] - positions_[i - 1]) / (times_[i] - times_[i - 1]));
    }
    return speed;
}

std::vector<double> RelaxationProblem::fitted(const RelaxingParameters& parameters) const {
    std::vector<double> indentations = positions_;
    for (double& indentation : indentations) {
        indentation -= parameters.contactPoint;
    }
    return relaxingForces(parameters, times_, indentations);
}

double RelaxationProblem::squares(const RelaxingParameters& parameters) const {
    const std::vector<double> forces = fitted(parameters);
    double sum = 0.0;
    for (std::size_t i = from_; i < to_; ++i) {
        sum += (forces[i] - forces_[i]) * (forces[i] - forces_[i]);
    }
    return sum;
}

std::vector<FreeParameter>
RelaxationProblem::freeParameters(const RelaxingParameters& start) const {
    constexpr double kWide = 1e3;
    std::vector<FreeParameter> free;
    const double depth = deepest(start.contactPoint);
    free.push_back({"contact_point_m", "m", start.contactPoint, start.contactPoint - depth,
                    start.contactPoint + depth, 0.01 * depth});
    const auto add = [&](const char* key, const char* unit, double value, double low, double high) {
        free.push_back({key, unit, value, low, high, 0.0});
    };
    const double modulus = start.longModulus + start.relaxingModulus;
    add(options_.relaxation ? "long_term_modulus_pa" : "youngs_modulus_pa", "Pa", start.longModulus,
        modulus / kWide, modulus * kWide);
    if (options_.relaxation) {
        add("relaxing_modulus_pa", "Pa", start.relaxingModulus, modulus / kWide, modulus * kWide);
        const double step = duration() / static_cast<double>(times_.size());
        add("relaxation_time_s", "s", start.relaxationTime, 0.1 * step, 10.0 * duration());
    }
    if (options_.drag) {
        add("drag_n_s", "N s", start.drag, start.drag / kWide, start.drag * kWide);
        add("drag_offset_m", "m", start.dragOffset, 1e-3 * depth, 10.0 * depth);
    }
    return free;
}

/// In the order of freeParameters().
RelaxingParameters RelaxationProblem::with(RelaxingParameters parameters,
                                           const std::vector<double>& values) const {
    auto value = values.begin();
    parameters.contactPoint = *value++;
    parameters.longModulus = *value++;
    if (options_.relaxation) {
        parameters.relaxingModulus = *value++;
        parameters.relaxationTime = *value++;
    }
    if (options_.drag) {
        parameters.drag = *value++;
        parameters.dragOffset = *value++;
    }
    return parameters;
}

BoundedFit RelaxationProblem::solve(const RelaxingParameters& start, bool forward) const {
    return fitWithin(
        freeParameters(start),
        [&](const std::vector<double>& values, Eigen::VectorXd& out) {
            const RelaxingParameters trial = with(start, values);
            const std::vector<double> forces = forward ? this->forward(trial) : fitted(trial);
            for (std::size_t i = from_; i < to_; ++i) {
                out[static_cast<Index>(i - from_)] = (forces[i] - forces_[i]) / range_;
            }
        },
        to_ - from_);
}

RelaxingParameters RelaxationProblem::elastic(double modulus, double contactPoint) const {
    RelaxingParameters parameters{.tipRadius = options_.tipRadius,
                                  .sphere = options_.sphere,
                                  .poissonRatio = options_.poissonRatio,
                                  .longModulus = modulus,
                                  .contactPoint = contactPoint};
    parameters.relaxationTime = duration();
    parameters.dragOffset = deepest(contactPoint);
    return parameters;
}

/// Starts over relaxation times and gaps.
std::vector<RelaxingParameters> startsOf(const RelaxationProblem& problem,
                                         const RelaxationFitOptions& options,
                                         const RelaxingParameters& elastic, double forceRange) {
    std::vector<RelaxingParameters> starts;
    const std::vector<double> times =
        options.relaxation ? std::vector{0.01, 0.05, 0.25} : std::vector{1.0};
    const std::vector<double> gaps = options.drag ? std::vector{0.1, 0.5} : std::vector{1.0};
    for (const double time : times) {
        for (const double gap : gaps) {
            RelaxingParameters start = elastic;
            if (options.relaxation) {
                start.longModulus = 0.5 * elastic.longModulus;
                start.relaxingModulus = 0.5 * elastic.longModulus;
                start.relaxationTime = time * problem.duration();
            }
            if (options.drag) {
                start.dragOffset = gap * problem.deepest(elastic.contactPoint);
                start.drag = 0.1 * forceRange * start.dragOffset / problem.fastest();
            }
            starts.push_back(start);
        }
    }
    return starts;
}

/// The samples of a fit as a cycle, with other forces; a dwell belongs to its retract.
MeasuredCycle asCycle(const RelaxationFit& fit, const std::vector<double>& forces) {
    MeasuredCycle cycle;
    for (std::size_t i = 0; i < fit.samples.size(); ++i) {
        CycleBranch& branch = i < fit.turn ? cycle.approach : cycle.retract;
        branch.time.push_back(fit.samples.time[i]);
        branch.base.push_back(fit.samples.base[i]);
        branch.force.push_back(forces[i]);
    }
    return cycle;
}

/// Contact is where the sample is indented.
CycleEvents indentedEvents(const RelaxationFit& fit) {
    CycleEvents events;
    const std::vector<double> positions = tipPositions(fit.samples, fit.stiffness);
    const auto indented = [&](std::size_t i) { return positions[i] > fit.parameters.contactPoint; };
    while (events.contactBegin + 2 < fit.turn && !indented(events.contactBegin)) {
        ++events.contactBegin;
    }
    events.contactEnd = fit.samples.size() - fit.turn;
    while (events.contactEnd > 2 && !indented(fit.turn + events.contactEnd - 1)) {
        --events.contactEnd;
    }
    return events;
}

void describe(RelaxationFit& fit, double noise) {
    MeasuredCycle measured = asCycle(fit, fit.samples.force);
    measured.noise = noise;
    const MeasuredCycle fitted = asCycle(fit, fit.fitted);
    const MeasuredCycle forward = asCycle(fit, fit.forward);
    const CycleEvents events = indentedEvents(fit);
    fit.residuals =
        cycleResiduals(measured, events, {fitted.approach.force, {}, fitted.retract.force},
                       {forward.approach.force, {}, forward.retract.force});
    fit.measured = cycleFigures(measured, events);
    fit.simulated = cycleFigures(forward, events);
}

/// The samples of a fit; `turn` becomes the first after the approach.
CycleBranch windowSamples(const MeasuredCycle& cycle, const RelaxationFitOptions& options,
                          std::size_t bins, std::size_t& turn) {
    for (const CycleBranch* branch : {&cycle.approach, &cycle.dwell, &cycle.retract}) {
        if (branch->time.size() != branch->base.size()) {
            throw Error("relaxation and drag need the times of the curve");
        }
    }
    const auto& down = cycle.approach.base;
    const auto& up = cycle.retract.base;
    auto first = down.begin();
    auto last = up.end();
    if (!options.wholeCycle) {
        const double begin = windowBegin(cycle, cycleEvents(cycle), options.tipRadius);
        first = std::find_if(first, down.end(), [&](double base) { return base >= begin; });
        last = std::find_if(up.begin(), last, [&](double base) { return base < begin; });
    }
    CycleBranch all =
        binned(cycle.approach, static_cast<std::size_t>(first - down.begin()), down.size(), bins);
    turn = all.size();
    append(all, binned(cycle.dwell, 0, cycle.dwell.size(), bins));
    append(all, binned(cycle.retract, 0, static_cast<std::size_t>(last - up.begin()), bins));
    return all;
}

}  // namespace

double windowBegin(const MeasuredCycle& cycle, const CycleEvents& events, double tipRadius) {
    const double contact = cycle.approach.base[events.contactBegin];
    const double way = contact - cycle.approach.base.front();
    return contact - std::min(0.5 * way, 0.5 * tipRadius);
}

RelaxationFit relaxationFit(const MeasuredCycle& cycle, const RelaxationFitOptions& options) {
    RelaxationFit result;
    result.stiffness = cycle.stiffness;
    result.samples = windowSamples(cycle, options, options.bins, result.turn);
    AdhesiveFitOptions elastic;
    elastic.law = options.sphere ? ContactLaw::Sneddon : ContactLaw::Hertz;
    elastic.tipRadius = options.tipRadius;
    elastic.branch = FittedBranch::Approach;
    const AdhesiveParameters first = adhesiveFit(cycle, elastic).parameters;
    const double range = cycle.forceRange();
    const RelaxationProblem problem(options, result, range);
    const double plane = 1.0 - (options.poissonRatio * options.poissonRatio);
    const RelaxingParameters start =
        problem.elastic(first.reducedModulus * plane, first.contactPoint);
    std::vector<RelaxingParameters> starts = startsOf(problem, options, start, range);
    std::sort(starts.begin(), starts.end(), [&](const auto& one, const auto& other) {
        return problem.squares(one) < problem.squares(other);
    });
    constexpr std::size_t kTried = 2;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(kTried, starts.size()); ++i) {
        const BoundedFit fit = problem.solve(starts[i], false);
        if (fit.fit.rms < least) {
            least = fit.fit.rms;
            result.bounded = fit;
            result.parameters = problem.with(starts[i], fit.values);
        }
    }
    if (options.forward) {
        constexpr std::size_t kForwardBins = 500;
        result.samples = windowSamples(cycle, options, kForwardBins, result.turn);
    }
    const RelaxationProblem last(options, result, range);
    if (options.forward) {
        result.bounded = last.solve(result.parameters, true);
        result.parameters = last.with(result.parameters, result.bounded.values);
    }
    result.fitted = last.fitted(result.parameters);
    result.forward = last.forward(result.parameters);
    describe(result, cycle.noise);
    return result;
}

SimulatedCycle simulated(const RelaxationFit& fit, const MeasuredCycle& cycle) {
    CycleBranch all;
    for (const CycleBranch* branch : {&cycle.approach, &cycle.dwell, &cycle.retract}) {
        append(all, {branch->time, branch->base, branch->force});
    }
    const std::vector<double> forces =
        simulatedForces(fit.parameters, fit.stiffness, all.time, all.base);
    const auto dwell = forces.begin() + static_cast<std::ptrdiff_t>(cycle.approach.size());
    const auto retract = dwell + static_cast<std::ptrdiff_t>(cycle.dwell.size());
    return {{forces.begin(), dwell}, {dwell, retract}, {retract, forces.end()}};
}

}  // namespace asperity
