#include "core/experiment/StudyStatistics.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace asperity {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kUpperTail = 0.025;  // of an interval of 95 %

double meanOf(std::span<const double> values) {
    return values.empty() ? kNone
                          : std::accumulate(values.begin(), values.end(), 0.0) /
                                static_cast<double>(values.size());
}

/// Sums of squares and products about the means.
struct Moments {
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
};

Moments momentsOf(std::span<const double> x, std::span<const double> y) {
    const double meanX = meanOf(x);
    const double meanY = meanOf(y);
    Moments moments;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - meanX;
        const double dy = y[i] - meanY;
        moments.xx += dx * dx;
        moments.xy += dx * dy;
        moments.yy += dy * dy;
    }
    return moments;
}

using Trials = std::vector<const TrialRecord*>;

std::vector<double> valuesOf(const Trials& trials, const TrialValue& value) {
    std::vector<double> values;
    for (const TrialRecord* trial : trials) {
        values.push_back(value(*trial));
    }
    return values;
}

std::map<int, Trials> byParticipant(const Trials& trials) {
    std::map<int, Trials> all;
    for (const TrialRecord* trial : trials) {
        all[trial->plan.participant].push_back(trial);
    }
    return all;
}

/// One value a participant.
template <class Reduce>
Estimate overParticipants(const Trials& trials, const Reduce& reduce) {
    std::vector<double> values;
    for (const auto& [participant, own] : byParticipant(trials)) {
        values.push_back(reduce(own));
    }
    return estimateOf(values);
}

Estimate meanOver(const Trials& trials, const TrialValue& value) {
    return overParticipants(
        trials, [&](const Trials& own) { return estimateOf(valuesOf(own, value)).mean; });
}

Estimate slopeOver(const Trials& trials, const TrialValue& value) {
    const TrialValue repeat = [](const TrialRecord& trial) {
        return static_cast<double>(trial.plan.repeat);
    };
    return overParticipants(trials, [&](const Trials& own) {
        return slopeOf(valuesOf(own, repeat), valuesOf(own, value));
    });
}

/// Deviations from the mean of the same participant's trials on the same material and lever.
std::vector<double> deviationsOf(const Trials& trials, const TrialValue& value) {
    const auto cellOf = [](const TrialRecord& trial) {
        return std::tuple(trial.plan.participant, trial.plan.material, trial.plan.lever);
    };
    std::map<std::tuple<int, std::size_t, std::size_t>, std::vector<double>> cells;
    for (const TrialRecord* trial : trials) {
        cells[cellOf(*trial)].push_back(value(*trial));
    }
    std::vector<double> deviations;
    for (const TrialRecord* trial : trials) {
        deviations.push_back(value(*trial) - estimateOf(cells[cellOf(*trial)]).mean);
    }
    return deviations;
}

/// The estimates of one study, one after the other.
class Statistician {
public:
    Statistician(const Study& study, std::span<const TrialRecord> trials)
        : study_(study), trials_(trials) {}

    std::vector<StudyEstimate> all() {
        for (const TaskKind task : {TaskKind::Above, TaskKind::On, TaskKind::Below}) {
            const Trials done = of([&](const TrialRecord& trial) { return kindOf(trial) == task; });
            if (!done.empty()) {
                addTask(task, done);
            }
        }
        return std::move(estimates_);
    }

private:
    template <class Holds>
    [[nodiscard]] Trials of(const Holds& holds) const {
        Trials chosen;
        for (const TrialRecord& trial : trials_) {
            if (holds(trial)) {
                chosen.push_back(&trial);
            }
        }
        return chosen;
    }

    [[nodiscard]] TaskKind kindOf(const TrialRecord& trial) const {
        return study_.tasks.at(trial.plan.task).kind;
    }

    void addTask(TaskKind task, const Trials& done) {
        add({.quantity = StudyQuantity::FaultShare, .task = task},
            overParticipants(done, [](const Trials& own) {
                const auto faults = std::ranges::count_if(
                    own, [](const TrialRecord* trial) { return trial->fault != Fault::None; });
                return static_cast<double>(faults) / static_cast<double>(own.size());
            }));
        const Trials counting = countingOf(done);
        if (counting.empty()) {
            return;
        }
        addMeans({.task = task}, counting);
        add({.quantity = StudyQuantity::ErrorLearning, .task = task},
            slopeOver(counting, &TrialRecord::errorPercent));
        add({.quantity = StudyQuantity::TimeLearning, .task = task},
            slopeOver(counting, &TrialRecord::time));
        add({.quantity = StudyQuantity::TimeAndError, .task = task},
            correlationOf(deviationsOf(counting, &TrialRecord::time),
                          deviationsOf(counting, &TrialRecord::errorPercent)));
        addCells(task, counting);
    }

    static Trials countingOf(const Trials& trials) {
        Trials counting;
        std::ranges::copy_if(trials, std::back_inserter(counting), &TrialRecord::counts);
        return counting;
    }

    void addCells(TaskKind task, const Trials& trials) {
        std::map<std::pair<std::size_t, std::size_t>, Trials> cells;
        for (const TrialRecord* trial : trials) {
            cells[{trial->plan.material, trial->plan.lever}].push_back(trial);
        }
        for (const auto& [cell, own] : cells) {
            addMeans({.task = task,
                      .material = study_.materials.at(cell.first).name,
                      .lever = study_.levers.at(cell.second).name},
                     own);
        }
    }

    void addMeans(StudyEstimate estimate, const Trials& trials) {
        estimate.quantity = StudyQuantity::ErrorPercent;
        add(estimate, meanOver(trials, &TrialRecord::errorPercent));
        estimate.quantity = StudyQuantity::Time;
        add(estimate, meanOver(trials, &TrialRecord::time));
    }

    void add(StudyEstimate estimate, const Estimate& value) {
        estimate.value = value;
        estimates_.push_back(std::move(estimate));
    }

    const Study& study_;
    std::span<const TrialRecord> trials_;
    std::vector<StudyEstimate> estimates_;
};

std::string textOf(const Estimate& estimate, const char* unit) {
    return estimate.hasInterval() ? formatted("%.3g (%.3g to %.3g) %s", estimate.mean, estimate.low,
                                              estimate.high, unit)
                                  : "–";
}

/// A measure taken under both of two conditions.
struct Measure {
    TrialValue value;
    const char* unit;
};

const Measure kError{&TrialRecord::errorPercent, "%"};
const Measure kTime{&TrialRecord::time, "s"};

/// The trials of one study, and what they say.
class Findings {
public:
    Findings(const Study& study, std::span<const TrialRecord> trials)
        : study_(study), trials_(trials) {}

    /// `more` has larger values than `less`.
    void isMore(const std::string& paper, const TrialChoice& more, const TrialChoice& less,
                const Measure& measure) {
        const Estimate difference = differenceOf(more, less, measure.value);
        add(paper, "difference " + textOf(difference, measure.unit),
            !difference.hasInterval() ? FindingVerdict::NotTested
            : difference.isAbove(0.0) ? FindingVerdict::Agrees
            : difference.isBelow(0.0) ? FindingVerdict::Differs
                                      : FindingVerdict::Open);
    }

    /// Nothing differs: an interval that leaves out 0 differs.
    void isNothing(const std::string& paper, const std::vector<Estimate>& values,
                   const char* unit) {
        std::string ours;
        FindingVerdict verdict = FindingVerdict::NotTested;
        for (const Estimate& value : values) {
            if (!value.hasInterval()) {
                continue;
            }
            ours += (ours.empty() ? "" : "; ") + textOf(value, unit);
            const bool isSome = value.isAbove(0.0) || value.isBelow(0.0);
            if (isSome || verdict == FindingVerdict::NotTested) {
                verdict = isSome ? FindingVerdict::Differs : FindingVerdict::Agrees;
            }
        }
        add(paper, ours, verdict);
    }

    void add(const std::string& paper, const std::string& ours, FindingVerdict verdict) {
        findings_.push_back({.paper = paper, .ours = ours, .verdict = verdict});
    }

    [[nodiscard]] Estimate differenceOf(const TrialChoice& one, const TrialChoice& other,
                                        const TrialValue& value) const {
        return pairedDifference(participantMeans(trials_, one, value),
                                participantMeans(trials_, other, value));
    }

    [[nodiscard]] TrialChoice task(TaskKind kind) const {
        return [this, kind](const TrialRecord& trial) {
            return study_.tasks.at(trial.plan.task).kind == kind;
        };
    }
    [[nodiscard]] TrialChoice on(TaskKind kind, const std::string& material) const {
        return [this, kind, material](const TrialRecord& trial) {
            return study_.tasks.at(trial.plan.task).kind == kind &&
                   study_.materials.at(trial.plan.material).name == material;
        };
    }

    [[nodiscard]] std::vector<StudyFinding> take() { return std::move(findings_); }

private:
    const Study& study_;
    std::span<const TrialRecord> trials_;
    std::vector<StudyFinding> findings_;
};

Estimate estimateIn(const std::vector<StudyEstimate>& statistics, StudyQuantity quantity,
                    TaskKind task) {
    const StudyEstimate* const found = find(statistics, quantity, task);
    return found == nullptr ? Estimate{} : found->value;
}

/// The paper relates time and error in C alone.
void addRelation(const std::vector<StudyEstimate>& statistics, Findings& findings) {
    const auto relation = [&](TaskKind task) {
        return estimateIn(statistics, StudyQuantity::TimeAndError, task);
    };
    const auto isSome = [](const Estimate& value) {
        return value.isAbove(0.0) || value.isBelow(0.0);
    };
    const Estimate above = relation(TaskKind::Above);
    const Estimate on = relation(TaskKind::On);
    const Estimate below = relation(TaskKind::Below);
    const bool isTold = std::isfinite(above.mean + on.mean + below.mean) &&
                        std::min({above.count, on.count, below.count}) > 3;
    const bool isOnlyThere = isSome(below) && !isSome(above) && !isSome(on);
    findings.add("time and error are related in C alone",
                 "correlation in A " + textOf(above, "") + "; B " + textOf(on, "") + "; C " +
                     textOf(below, ""),
                 !isTold       ? FindingVerdict::NotTested
                 : isOnlyThere ? FindingVerdict::Agrees
                               : FindingVerdict::Differs);
}

}  // namespace

Estimate estimateOf(std::span<const double> values) {
    Estimate estimate{.count = values.size(),
                      .mean = meanOf(values),
                      .deviation = kNone,
                      .low = kNone,
                      .high = kNone};
    if (values.size() < 2) {
        return estimate;
    }
    const auto count = static_cast<double>(values.size());
    estimate.deviation = std::sqrt(momentsOf(values, values).xx / (count - 1.0));
    const boost::math::students_t spread(count - 1.0);
    const double half = boost::math::quantile(boost::math::complement(spread, kUpperTail)) *
                        estimate.deviation / std::sqrt(count);
    estimate.low = estimate.mean - half;
    estimate.high = estimate.mean + half;
    return estimate;
}

Estimate correlationOf(std::span<const double> x, std::span<const double> y) {
    const Moments moments = momentsOf(x, y);
    Estimate estimate{.count = x.size(),
                      .mean = moments.xy / std::sqrt(moments.xx * moments.yy),
                      .deviation = kNone,
                      .low = kNone,
                      .high = kNone};
    if (x.size() < 4 || !(moments.xx > 0.0 && moments.yy > 0.0)) {
        estimate.mean = moments.xx > 0.0 && moments.yy > 0.0 ? estimate.mean : kNone;
        return estimate;
    }
    const double half =
        boost::math::quantile(boost::math::complement(boost::math::normal(), kUpperTail)) /
        std::sqrt(static_cast<double>(x.size()) - 3.0);
    const double middle = std::atanh(estimate.mean);
    estimate.low = std::tanh(middle - half);
    estimate.high = std::tanh(middle + half);
    return estimate;
}

double slopeOf(std::span<const double> x, std::span<const double> y) {
    const Moments moments = momentsOf(x, y);
    return moments.xx > 0.0 ? moments.xy / moments.xx : kNone;
}

std::vector<StudyEstimate> studyStatistics(const Study& study,
                                           std::span<const TrialRecord> trials) {
    return Statistician(study, trials).all();
}

std::map<int, double> participantMeans(std::span<const TrialRecord> trials,
                                       const TrialChoice& choice, const TrialValue& value) {
    std::map<int, std::vector<double>> values;
    for (const TrialRecord& trial : trials) {
        if (trial.counts() && choice(trial)) {
            values[trial.plan.participant].push_back(value(trial));
        }
    }
    std::map<int, double> means;
    for (const auto& [participant, own] : values) {
        means[participant] = estimateOf(own).mean;
    }
    return means;
}

Estimate pairedDifference(const std::map<int, double>& one, const std::map<int, double>& other) {
    std::vector<double> differences;
    for (const auto& [participant, mean] : one) {
        if (const auto found = other.find(participant); found != other.end()) {
            differences.push_back(mean - found->second);
        }
    }
    return estimateOf(differences);
}

const StudyEstimate* find(std::span<const StudyEstimate> estimates, StudyQuantity quantity,
                          TaskKind task, const std::string& material) {
    const auto found = std::ranges::find_if(estimates, [&](const StudyEstimate& estimate) {
        return estimate.quantity == quantity && estimate.task == task &&
               estimate.material == material;
    });
    return found == estimates.end() ? nullptr : &*found;
}

std::vector<StudyFinding> findingsOf(const Study& study, std::span<const TrialRecord> trials) {
    const std::vector<StudyEstimate> statistics = studyStatistics(study, trials);
    const std::string oxide = "silicon_oxide";
    const std::string polystyrene = "polystyrene";
    const std::string rubber = "silicone_rubber";
    const TaskKind a = TaskKind::Above;
    const TaskKind b = TaskKind::On;
    const TaskKind c = TaskKind::Below;
    Findings findings(study, trials);
    findings.isMore("the error is larger in B than in C", findings.task(b), findings.task(c),
                    kError);
    findings.isMore("the error is larger in C than in A", findings.task(c), findings.task(a),
                    kError);
    std::vector<Estimate> between;
    for (const auto& [one, other] : {std::pair(oxide, polystyrene), std::pair(polystyrene, rubber),
                                     std::pair(oxide, rubber)}) {
        between.push_back(findings.differenceOf(findings.on(a, one), findings.on(a, other),
                                                &TrialRecord::errorPercent));
    }
    findings.isNothing("in A the error is about the same on all materials", between, "%");
    findings.isMore("in B the error is larger on silicon oxide than on rubber",
                    findings.on(b, oxide), findings.on(b, rubber), kError);
    findings.isMore("in C the error is larger on rubber than on polystyrene",
                    findings.on(c, rubber), findings.on(c, polystyrene), kError);
    findings.isMore("in C polystyrene takes longer than rubber", findings.on(c, polystyrene),
                    findings.on(c, rubber), kTime);
    std::vector<Estimate> errors;
    std::vector<Estimate> times;
    for (const TaskKind task : {a, b, c}) {
        errors.push_back(estimateIn(statistics, StudyQuantity::ErrorLearning, task));
        times.push_back(estimateIn(statistics, StudyQuantity::TimeLearning, task));
    }
    findings.isNothing("the error does not change from repeat to repeat", errors, "% a repeat");
    findings.isNothing("the time does not change from repeat to repeat", times, "s a repeat");
    addRelation(statistics, findings);
    return findings.take();
}

}  // namespace asperity
