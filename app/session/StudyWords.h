#pragma once

#include "app/experiment/OpenStudy.h"
#include "ui/experiment/TrialPanel.h"

namespace asperity {

/// Where a study with a person is.
enum class StudyPhase {
    Choosing,  ///< none is under way
    Training,  ///< the person tries the program
    Ready,     ///< the tip is at the start of a trial
    Trial,
    Result,  ///< the tip is where a trial ended
    Paused,
    Finished,  ///< all trials of the person are done
};

/// A study under way, as it is shown.
struct StudyMoment {
    StudyPhase phase = StudyPhase::Choosing;
    PlannedTrial trial;         ///< the next one, or the present one
    QString refusal;            ///< why no trial can begin; empty: one can
    bool isDrawing = false;     ///< results: they read the folder, which nobody changes meanwhile
    bool canStrikeOut = false;  ///< the last trial, which counts
};

/// What the participant reads and can do.
[[nodiscard]] TrialStage stageWords(const OpenStudy& study, const StudyMoment& moment);
/// What came of a trial.
[[nodiscard]] TrialResult resultWords(const TrialRecord& record);

}  // namespace asperity
