#pragma once

#include "app/experiment/OperatorStudy.h"
#include "app/experiment/ParticipantStudy.h"

#include <filesystem>

namespace asperity {

/// A study that a person is about to do: its scenes are loaded, its folder is claimed.
struct OpenStudy {
    /// Goes on with the study of the folder, or begins it there.
    /// @throw Error where the study is one for the operator model alone, the folder holds another
    /// one or cannot be written; StudyRefused; InputError; Canceled
    OpenStudy(Study wanted, const std::filesystem::path& out, int participant, Progress* progress);

    Study study;
    StudyScenes scenes;
    ExperimentFolder folder;
    ParticipantStudy person;
};

}  // namespace asperity
