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

/// What the participant reads and can do. @param trial the next one, or the present one
/// @param refusal why no trial can begin; empty: one can
/// @param drawing results: they read the folder, which nobody changes meanwhile
[[nodiscard]] TrialStage stageWords(const OpenStudy& study, const PlannedTrial& trial,
                                    StudyPhase phase, const QString& refusal, bool drawing);
/// What came of a trial.
[[nodiscard]] TrialResult resultWords(const TrialRecord& record);

}  // namespace asperity
