#include "app/experiment/ParticipantStudy.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

namespace {

/// Of the orders: the same in every study of people, so that a folder needs to keep none.
constexpr std::uint64_t kSeed = 1;

int lastParticipant(std::span<const TrialRecord> trials) {
    int last = 0;
    for (const TrialRecord& trial : trials) {
        last = std::max(last, trial.plan.participant);
    }
    return last;
}

}  // namespace

ParticipantStudy::ParticipantStudy(ExperimentFolder& folder, int participant)
    : folder_(folder), participant_(participant) {
    if (!areInOrderOfPeople(folder.study(), folder.trials())) {
        throw Error(folder.path().string() +
                    ": holds trials in another order, as of operators of a model; choose another "
                    "folder");
    }
    trials_ = planTrials(folder.study(), participant, kSeed);
    std::erase_if(trials_, [participant](const PlannedTrial& trial) {
        return trial.participant != participant;
    });
}

int ParticipantStudy::done() const {
    return static_cast<int>(std::ranges::count_if(
        trials_, [this](const PlannedTrial& trial) { return !folder_.nextAttempt(trial); }));
}

bool ParticipantStudy::isNew() const {
    return std::ranges::none_of(folder_.trials(), [this](const TrialRecord& trial) {
        return trial.plan.participant == participant_;
    });
}

std::optional<PlannedTrial> ParticipantStudy::next() const {
    for (const PlannedTrial& trial : trials_) {
        if (const auto attempt = folder_.nextAttempt(trial)) {
            return attempt;
        }
    }
    return std::nullopt;
}

bool areInOrderOfPeople(const Study& study, std::span<const TrialRecord> trials) {
    return !unplannedTrial(trials, planTrials(study, lastParticipant(trials), kSeed));
}

int participantToGoOn(const Study& study, std::span<const TrialRecord> trials) {
    const std::size_t perPerson = planTrials(study, 1, kSeed).size();
    for (int participant = 1;; ++participant) {
        const auto counting = std::ranges::count_if(trials, [participant](const TrialRecord& one) {
            return one.plan.participant == participant && one.counts();
        });
        if (static_cast<std::size_t>(counting) < perPerson) {
            return participant;
        }
    }
}

}  // namespace asperity
