#pragma once

#include "app/recording/RunRecording.h"
#include "app/session/DeviceControl.h"
#include "app/session/SceneEdits.h"
#include "app/session/StudyChoice.h"
#include "app/session/StudyStand.h"
#include "app/session/StudyViews.h"
#include "app/session/StudyWords.h"
#include "core/experiment/TrialPlaces.h"
#include "core/experiment/WatchedTrial.h"

#include <QString>

#include <optional>

class QStackedWidget;

namespace asperity {

class TrialPanel;

/// A positioning study with people: training, one trial after the other, each begun and ended by
/// one button, and what came of it. Meanwhile scene and knobs are the study's.
class StudyControl : public QObject {
    Q_OBJECT

public:
    StudyControl(MainWindow& window, RunControl& runs, DeviceControl& devices, SceneEdits& edits);

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// Once a frame, before its ticks are fetched. There is a run.
    void advance();
    /// What the form offers.
    [[nodiscard]] StudyChoice& choice() { return choice_; }

private:
    void open();
    void begin(const std::shared_ptr<OpenStudy>& study);
    void enter(StudyPhase phase);
    /// Where the participant has changed the device, it is said.
    void warnOfDevice();
    [[nodiscard]] std::string deviceKey() const;
    /// What the button does.
    void press();
    void makeReady();
    void placeTrial();
    /// The knobs are as the study has them. @param clutched the device moves nothing
    void turnKnobs(bool clutched);
    /// Why no trial can begin; empty: one can.
    [[nodiscard]] QString refusal() const;
    void beginTrial();
    void watchTrial();
    void endTrial(const TrialEnd& end);
    /// What the run's end leaves of a trial: nothing.
    void drop();
    void strikeOut(const QString& why);
    void pause();
    void leave();

    void show();
    void showTime();
    void showResult(const TrialRecord& record);

    MainWindow& window_;
    RunControl& runs_;
    DeviceControl& devices_;
    SceneEdits& edits_;
    QStackedWidget* page_;
    TrialPanel* panel_;
    StudyResultsControl results_;
    StudyChoice choice_;
    StudyViews views_;

    StudyPhase phase_ = StudyPhase::Choosing;
    double changed_ = 0.0;              ///< when the phase did, on the clock [s]
    std::shared_ptr<OpenStudy> study_;  ///< null: none is under way
    std::optional<StudyStand> before_;
    const DeviceDriver* driver_ = nullptr;  ///< that the study is done with
    PlannedTrial plan_;                     ///< the next trial, or the present one
    TrialPlaces places_;
    std::optional<PlannedTrial> last_;  ///< that ended and counts
    std::optional<WatchedTrial> trial_;
    std::unique_ptr<RunRecording> recording_;
    QString refusal_;          ///< why the button began no trial; empty: it did
    bool wasDrawing_ = false;  ///< results, in the last frame
    bool buttonWasDown_ = false;
    bool isPressed_ = false;     ///< the device's button, since the last frame
    double trainingEnds_ = 0.0;  ///< on the clock [s]
};

}  // namespace asperity
