#pragma once

#include "app/experiment/ExperimentFolder.h"
#include "app/loading/SceneLoader.h"
#include "core/Progress.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace asperity {

/// The scenes of a study, each material with each lever.
class StudyScenes {
public:
    /// @throw as loadScene(); StudyRefused where the study contradicts one of them
    StudyScenes(const Study& study, Progress* progress);

    [[nodiscard]] const LoadedScene& of(std::size_t material, std::size_t lever) const {
        return scenes_.at(material * levers_ + lever);
    }

private:
    std::size_t levers_;
    std::vector<LoadedScene> scenes_;
};

/// Settings for a study by operators of the model.
struct OperatorRun {
    int operators = 6;
    std::uint64_t seed = 1;
    bool record = false;  ///< every tick of each trial, as `asperity replay` reads it
};

/// Has all trials done that do not count yet, on all cores: the results do not depend on their
/// number. A trial that a fault ends is done again, five times at most.
/// @throw Canceled, Error; what was done is kept
void runOperators(const StudyScenes& scenes, const OperatorRun& run, ExperimentFolder& folder,
                  Progress* progress);

/// One person's trials in the study of a folder: which trial comes next.
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
    /// Returns how many of these count already.
    [[nodiscard]] int done() const;
    /// Returns whether the person has not begun a trial yet.
    [[nodiscard]] bool isNew() const;
    /// Returns none when all are done.
    [[nodiscard]] std::optional<PlannedTrial> next() const;

private:
    ExperimentFolder& folder_;
    int participant_;
    std::vector<PlannedTrial> trials_;
};

/// Returns whether trials are in the order in which people do a study: those of operators of a
/// model may be in another one.
[[nodiscard]] bool areInOrderOfPeople(const Study& study, std::span<const TrialRecord> trials);

/// The first participant who has not done all trials of a study; without trials 1.
[[nodiscard]] int participantToGoOn(const Study& study, std::span<const TrialRecord> trials);

/// A study that a person is about to do: its scenes are loaded, its folder is claimed.
struct OpenStudy {
    /// Resumes the study of the folder, or starts it there.
    /// @throw Error where the study is one for the operator model alone, the folder holds another
    /// one or cannot be written; StudyRefused; InputError; Canceled
    OpenStudy(Study wanted, const std::filesystem::path& out, int participant, Progress* progress);

    Study study;
    StudyScenes scenes;
    ExperimentFolder folder;
    ParticipantStudy person;
};

}  // namespace asperity
