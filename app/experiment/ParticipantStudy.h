#pragma once

#include "app/experiment/ExperimentFolder.h"

namespace asperity {

/// One person's way through the study of a folder: which trial comes next.
class ParticipantStudy {
public:
    /// @param folder outlives this
    /// @param participant from 1
    /// @throw Error where the folder's trials were planned otherwise
    ParticipantStudy(ExperimentFolder& folder, int participant);

    [[nodiscard]] ExperimentFolder& folder() const noexcept { return folder_; }
    [[nodiscard]] int participant() const noexcept { return participant_; }
    /// Trials that the person has to do.
    [[nodiscard]] int count() const noexcept { return static_cast<int>(trials_.size()); }
    /// Of these, so many count already.
    [[nodiscard]] int done() const;
    /// Whether the person has begun none yet.
    [[nodiscard]] bool isNew() const;
    /// None: all are done.
    [[nodiscard]] std::optional<PlannedTrial> next() const;

private:
    ExperimentFolder& folder_;
    int participant_;
    std::vector<PlannedTrial> trials_;
};

/// Whether trials are in the order in which people do a study: those of operators of a model may be
/// in another one.
[[nodiscard]] bool areInOrderOfPeople(const Study& study, std::span<const TrialRecord> trials);

/// The first participant who has not done all trials of a study; without trials 1.
[[nodiscard]] int participantToGoOn(const Study& study, std::span<const TrialRecord> trials);

}  // namespace asperity
