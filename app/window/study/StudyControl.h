#pragma once

#include "app/recording/RunRecording.h"
#include "app/window/RunControl.h"
#include "app/window/Stage.h"
#include "app/window/study/StudyChoice.h"
#include "app/window/study/TrialPanel.h"
#include "core/Vector.h"
#include "core/experiment/Study.h"
#include "core/experiment/TrialPlan.h"
#include "core/experiment/TrialRun.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "ui/view/MapTool.h"
#include "ui/view/Shading.h"

#include <QString>

#include <memory>
#include <optional>

class QStackedWidget;

namespace asperity {

class LivePanels;

/// Target position of the tip, as a green cross-hair on the whole scan.
class TargetTool : public MapTool {
    Q_OBJECT

public:
    using MapTool::MapTool;

    /// World [m]; none: there is no target.
    void setTarget(const std::optional<QPointF>& target);
    [[nodiscard]] const std::optional<QPointF>& target() const { return target_; }

    void paint(QPainter& painter, const OverviewMap& map) const override;

private:
    std::optional<QPointF> target_;  ///< [m]
};

/// Views during a study: they show the target, as wide a part of the sample for all participants,
/// and nothing that the study hides.
class StudyViews {
public:
    explicit StudyViews(LivePanels& live);

    /// A study begins: direction and options are the study's.
    void begin(const Study& study);
    /// The tip is at the start of a trial. @param target [m]
    void showTrial(const Vector3& target);
    void forgetTarget() { showTarget(std::nullopt); }
    /// Turns the large view by steps.
    void turn(int right, int up);

private:
    void showTarget(const std::optional<Vector3>& target);

    LivePanels& live_;
    TargetTool mark_;
    double halfWidth_ = 0.0;  ///< of the large view when a trial begins [m]
};

/// State of the window before a study, to be restored after it.
class SavedView {
public:
    /// There is a run; both outlive this.
    SavedView(LivePanels& live, RunControl& runs);

    /// The scene with its knobs, device and view are there again, the tip waits above its position.
    void restore() const;

private:
    LivePanels& live_;
    RunControl& runs_;
    std::shared_ptr<const LoadedScene> scene_;
    Vector2 position_;  ///< of the base [m]
    Settings settings_;
    DeviceScale scale_;
    ViewOptions options_;
    bool hasSecondView_;
    double halfWidth_;  ///< of the large view [m]
    double azimuth_;    ///< same, see ViewCamera [rad]
    double elevation_;  ///< [rad]
};

class TrialPanel;

/// A positioning study with people: training, one trial after the other, each begun and ended by
/// one button, and what came of it. Until then the study holds scene and knobs.
class StudyControl : public Feature {
    Q_OBJECT

public:
    explicit StudyControl(Stage& stage);

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// Once a frame, before its ticks are fetched. There is a run.
    void advance();
    /// Choices of the form.
    [[nodiscard]] StudyChoice& choice() { return choice_; }

private:
    void addEntries();
    void open();
    void begin(const std::shared_ptr<OpenStudy>& study);
    void enter(StudyPhase phase);
    /// Warns where the participant has changed the device.
    void warnOfDevice();
    [[nodiscard]] std::string deviceKey() const;
    /// Acts on a press of the button.
    void press();
    void makeReady();
    void placeTrial();
    /// The knobs are as the study has them. @param clutched the device moves nothing
    void turnKnobs(bool clutched);
    /// Returns why no trial can begin; empty: one can.
    [[nodiscard]] QString refusal() const;
    void beginTrial();
    void watchTrial();
    void endTrial(const TrialEnd& end);
    /// Discards the trial when the run ends.
    void drop();
    void strikeOut(const QString& why);
    void pause();
    void leave();

    void show();
    void showTime();
    void showResult(const TrialRecord& record);

    QStackedWidget* page_;
    TrialPanel* panel_;
    StudyResultsControl results_;
    StudyChoice choice_;
    StudyViews views_;

    StudyPhase phase_ = StudyPhase::Choosing;
    double changed_ = 0.0;              ///< when the phase did, on the clock [s]
    std::shared_ptr<OpenStudy> study_;  ///< null: none is under way
    std::optional<SavedView> before_;
    const DeviceDriver* driver_ = nullptr;  ///< that the study is done with
    PlannedTrial plan_;                     ///< the next trial, or the present one
    TrialPositions positions_;
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
