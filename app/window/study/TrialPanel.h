#pragma once

#include "app/experiment/OpenStudy.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace asperity {

class ReadingGrid;

/// Progress of a study, as a participant reads it.
struct TrialStage {
    QString heading;      ///< "Participant 1, trial 3 of 24"
    int done = 0;         ///< trials
    int count = 0;        ///< same
    QString task;         ///< what is to be done, in large letters
    QString instruction;  ///< what comes next
    QString action;       ///< what the button does; empty: nothing can be done now
    bool canPause = false;
    bool isPaused = false;
    bool canStrikeOut = false;  ///< the trial whose result is shown
    bool canShowResults = false;
};

/// Outcome of a trial, in words.
struct TrialResult {
    QString name;  ///< which trial, and whether it counts
    QString error;
    QString share;  ///< of the way
    QString time;
    QString force;
    QString note;  ///< why it does not count; empty: it does
};

/// A study under way: the task, the one button that begins and ends a trial, and what came of the
/// last one. Setters show a state and emit nothing.
class TrialPanel : public QWidget {
    Q_OBJECT

public:
    explicit TrialPanel(QWidget* parent = nullptr);

    void showStage(const TrialStage& stage);
    void showTime(const QString& time);
    void showResult(const TrialResult& result);
    void forgetResult() { showResult({}); }

Q_SIGNALS:
    void actionChosen();
    /// @param why in one line
    void strikeOutChosen(const QString& why);
    void pauseChosen();
    void resultsChosen();
    void leaveChosen();
    /// The view shall turn, in steps: to the right, upwards.
    void turnChosen(int right, int up);

private:
    [[nodiscard]] QWidget* newTask();
    [[nodiscard]] QWidget* newAction();
    [[nodiscard]] QWidget* newResult();
    [[nodiscard]] QWidget* newTurning();
    void askWhy();

    QLabel* heading_;
    QProgressBar* progress_;
    QLabel* task_;
    QLabel* instruction_;
    QPushButton* action_;
    QLabel* time_;
    QLabel* resultName_;
    ReadingGrid* readings_;
    QLabel* note_;
    QPushButton* strikeOut_;
    QPushButton* pause_;
    QPushButton* results_;
};

/// Phases of a study with a person.
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
    bool isDrawing = false;     ///< results: they read the folder, which nobody else changes
    bool canStrikeOut = false;  ///< the last trial, which counts
};

/// Returns what the participant reads and can do.
[[nodiscard]] TrialStage stageWords(const OpenStudy& study, const StudyMoment& moment);
/// Returns the outcome of a trial, in words.
/// @param noise standard deviation of the estimated force; a largest force within it is none [N]
[[nodiscard]] TrialResult resultWords(const TrialRecord& record, double noise);

}  // namespace asperity
