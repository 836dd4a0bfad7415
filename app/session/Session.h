#pragma once

#include "app/session/BundleControl.h"
#include "app/session/ClipboardControl.h"
#include "app/session/ColorControl.h"
#include "app/session/ComparisonControl.h"
#include "app/session/DeviceControl.h"
#include "app/session/EngageControl.h"
#include "app/session/EntryControl.h"
#include "app/session/ExportControl.h"
#include "app/session/FidelityControl.h"
#include "app/session/HapticControl.h"
#include "app/session/HelpControl.h"
#include "app/session/MaterialControl.h"
#include "app/session/MeasureControl.h"
#include "app/session/MessageControl.h"
#include "app/session/ModelFitControl.h"
#include "app/session/OpenControl.h"
#include "app/session/PathControl.h"
#include "app/session/PlaybackControl.h"
#include "app/session/ProbeControl.h"
#include "app/session/RecordingControl.h"
#include "app/session/RunControl.h"
#include "app/session/ScanReportControl.h"
#include "app/session/SceneControl.h"
#include "app/session/SceneEdits.h"
#include "app/session/ScenePanelControl.h"
#include "app/session/SessionControl.h"
#include "app/session/StudyControl.h"
#include "app/session/ViewControl.h"

#include <QTimer>

namespace asperity {

/// The window with all that is behind it: connects the controls to one another, and has them move
/// on once a frame.
class Session : public QObject {
public:
    /// @param framePeriod from one frame to the next [ms]; tests that share a processor take longer
    explicit Session(MainWindow& window, int framePeriod = kFramePeriod);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// The present run; null before the first scene.
    [[nodiscard]] LiveRun* run() const { return runs_.run(); }
    [[nodiscard]] RunControl& runs() { return runs_; }
    /// What changes the scene.
    [[nodiscard]] SceneEdits& edits() { return edits_; }
    [[nodiscard]] SceneControl& scenes() { return scenes_; }
    /// Materials and probes of the user's own.
    [[nodiscard]] LibraryControl& materials() { return materials_; }
    [[nodiscard]] LibraryControl& probes() { return probes_; }
    [[nodiscard]] SessionControl& saving() { return saving_; }
    /// The session is kept in a folder, whose files are no recent ones of the user's.
    void keepIn(const std::filesystem::path& folder);
    [[nodiscard]] OpenControl& files() { return files_; }
    [[nodiscard]] ExportControl& exports() { return exports_; }
    [[nodiscard]] DeviceControl& devices() { return devices_; }
    [[nodiscard]] PathControl& paths() { return paths_; }
    [[nodiscard]] RecordingControl& recordings() { return recordings_; }
    [[nodiscard]] BundleControl& bundles() { return bundles_; }
    [[nodiscard]] PlaybackControl& playback() { return playback_; }
    [[nodiscard]] ComparisonControl& comparisons() { return comparisons_; }
    [[nodiscard]] MeasureControl& measuring() { return measuring_; }
    [[nodiscard]] StudyControl& studies() { return studies_; }
    [[nodiscard]] const ViewControl& views() const { return views_; }

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static constexpr int kFramePeriod = 16;  ///< [ms]

    void stop();
    void advance();

    MainWindow& window_;
    // In the order in which they hear that a run begins or ends.
    RunControl runs_;
    SceneEdits edits_;
    RecordingControl recordings_;
    ModelFitControl fits_;
    DeviceControl devices_;
    SceneControl scenes_;
    OpenControl files_;
    ScanReportControl reports_;
    MaterialControl materials_;
    ProbeControl probes_;
    ScenePanelControl scenePanel_;
    FidelityControl fidelity_;
    PathControl paths_;
    EngageControl engaging_;
    StudyControl studies_;
    HapticControl haptics_;
    ViewControl views_;
    MeasureControl measuring_;
    PlaybackControl playback_;
    ComparisonControl comparisons_;
    ColorControl colors_;
    MessageControl messages_;
    ClipboardControl clipboard_;
    ExportControl exports_;
    HelpControl help_;
    SessionControl saving_;
    BundleControl bundles_;
    EntryControl entries_;
    QTimer frames_;
    double lastFrame_ = 0.0;  ///< [s]
};

}  // namespace asperity
