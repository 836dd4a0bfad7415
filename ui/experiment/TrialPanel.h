#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace asperity {

class ReadingGrid;

/// Where a study is, as a participant reads it.
struct TrialStage {
    QString place;        ///< "Participant 1, trial 3 of 24"
    int done = 0;         ///< trials
    int count = 0;        ///< likewise
    QString task;         ///< what is to be done, in large letters
    QString instruction;  ///< what comes next
    QString action;       ///< what the button does; empty: nothing can be done now
    bool canPause = false;
    bool isPaused = false;
    bool canStrikeOut = false;  ///< the trial whose result is shown
    bool canShowResults = false;
};

/// What came of a trial, in words.
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

    QLabel* place_;
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

}  // namespace asperity
