#include "core/experiment/StudyStatistics.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace asperity {

namespace {

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

}  // namespace

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

}  // namespace asperity
