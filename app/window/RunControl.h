#pragma once

#include "app/runs/LiveRun.h"
#include "app/window/ShownRecording.h"
#include "app/window/SteadyForce.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

class QAction;

namespace asperity {

struct DeviceDriver;
class Host;
class LivePanels;

/// The run behind the window: begins and ends it, lets it pause and go on, turns its knobs.
class RunControl : public QObject {
    Q_OBJECT

public:
    /// @param host, live outlive this
    RunControl(Host& host, LivePanels& live);

    /// The present run; null before the first scene.
    [[nodiscard]] LiveRun* run() const { return run_.get(); }
    /// Who gets every tick, in order.
    void setSink(TickSink sink) { sink_ = std::move(sink); }
    /// Passes all ticks of the run since the last time to the sink. There is a run.
    void fetch();

    /// Shows a scene that is loaded, and starts its loop. Forces that are off, or that a fault
    /// keeps away, stay off. @param tip waits above this position if it is on the scan [m]
    void use(LoadedScene scene, const std::optional<Vector2>& tip = std::nullopt);
    /// The loop begins again above the same position, or another one, with the same knobs, on the
    /// scene changed. There is a run. @param tip world [m]
    void replace(LoadedScene scene, const std::optional<Vector2>& tip = std::nullopt);
    /// The loop begins again on a scene, with the base at a position and with these knobs; device
    /// and view stay. Forces that are off, or that a fault keeps away, stay off. There is a run.
    /// @param start world [m]
    void place(LoadedScene scene, const Vector3& start, const Settings& settings);
    /// The run goes on with the model that was found for it, if LiveRun::mayAdoptModel() still
    /// holds after the latest tick. @return whether it does
    [[nodiscard]] bool adoptModel(const LoadedScene& fitted);
    /// Ends the run, if there is one.
    void end();

    void start();
    void pause();
    /// Turns knobs; one that the device refuses goes back, and the window shows why.
    void turn(const std::function<void(Settings&)>& knobs);
    void setForces(bool on);
    /// Shows how the knobs are. There is a run.
    void showKnobs();

    /// The scene that the window shows: of the recording that is open, else of the run. There is a
    /// run.
    [[nodiscard]] const Scene& scene() const { return loaded().scene; }
    [[nodiscard]] const LoadedScene& loaded() const {
        return recording_ ? *recording_->loaded() : run_->loaded();
    }
    /// The same, for who works with it beside the window.
    [[nodiscard]] std::shared_ptr<const LoadedScene> shared() const {
        return recording_ ? recording_->loaded() : run_->shared();
    }
    /// Returns the solver of the half-space of that scene; null: it does not ask for one.
    [[nodiscard]] HalfSpaceWorker* halfSpace() const {
        return recording_ ? recording_->halfSpace() : run_->halfSpace();
    }
    /// The tick that the window shows: of the recording that is open, else the latest one of the
    /// loop, with the steady force (SteadyForce). There is a run.
    [[nodiscard]] const Snapshot& shown();
    /// The last seconds up to that tick, in order. There is a run.
    [[nodiscard]] std::vector<TickSample> shownTicks();

    [[nodiscard]] bool showsRecording() const { return recording_.has_value(); }
    /// Returns the folder or bundle of the recording that is open; empty: none is, or it is on no
    /// disk.
    [[nodiscard]] std::filesystem::path openRecording() const {
        return recording_ ? recording_->input() : std::filesystem::path();
    }
    /// Shows a recording, at one of its ticks, instead of the run, which pauses: its scene, device,
    /// loop and black box stay as they are. There is a run.
    /// @param input its folder or bundle; empty: it is on no disk
    void showRecording(std::shared_ptr<const LoadedScene> loaded,
                       const std::filesystem::path& input, const TickSample& first);
    /// Shows the last one of these ticks of the recording. @param goesOn they follow those before
    void showRecorded(std::span<const TickSample> ticks, bool goesOn);
    /// Sets how fast the recording plays, see ShownRecording. There is one.
    void setPlaying(double speed) { recording_->setPlaying(speed); }
    /// Shows the run again as it was, paused where it was.
    void showLive();
    /// Sets aside what a feature shows of the scene. @return puts it back
    using SetAside = std::function<std::function<void()>()>;
    /// Calls a function before a recording is shown, of several the last one first, and what it
    /// returns once the run is shown again, the first one first.
    void beforeRecording(SetAside setAside) { setAsides_.push_back(std::move(setAside)); }

    /// Sets whether ticks of the run are being written to files.
    void setRecorded(bool recorded) { isRecorded_ = recorded; }
    [[nodiscard]] bool isRecorded() const { return isRecorded_; }
    /// Sets which driver has the tip. @param driver null: a path has it
    void setDriver(const DeviceDriver* driver) { driver_ = driver; }
    [[nodiscard]] const DeviceDriver* driver() const { return driver_; }
    /// Returns whether the scene that is shown is on another scan, or on another part of one, than
    /// that before.
    [[nodiscard]] bool isOnOtherScan() const { return isOnOtherScan_; }

    /// Returns why the tip cannot be moved for what is shown: a recording; empty: it can.
    [[nodiscard]] const QString& tipRefusal() const { return tipRefusal_; }

    /// Locks scene and knobs for all but the caller. @param why for tool tips;
    /// empty: they are the user's again
    void fix(const QString& why);
    /// Nobody switches forces on while scene and knobs are fixed.
    void keepForcesOff() { forcesStayOff_ = true; }
    [[nodiscard]] const QString& fixedBy() const { return fixedBy_; }

    /// Returns why nothing of the run can be shown; empty: it can.
    [[nodiscard]] QString showRefusal() const;
    /// Returns why a user cannot change the run now; empty: it can be changed.
    [[nodiscard]] QString changeRefusal() const;
    /// Returns why a user cannot move the tip now; empty: it can be moved.
    [[nodiscard]] QString moveRefusal() const;
    /// Returns why the scene that is shown stays as it is; empty: it can be changed.
    [[nodiscard]] const QString& editRefusal() const {
        return fixedBy_.isEmpty() ? tipRefusal_ : fixedBy_;
    }
    /// Has Esc switch the forces off, whatever has the focus, or not.
    void setEmergencyStop(bool active);

Q_SIGNALS:
    /// The run is about to go. Its loop rests, and all of its ticks are fetched.
    void ending();
    /// Another run is there and shown; its loop does not run yet.
    void begun();
    /// After begun(): its scene is the one before, changed.
    void rebuilt();
    /// The loop begins, or goes on.
    void started();
    /// The scene that is shown gives way to that of a recording, or to the run's again.
    void sceneLeaving();
    /// A recording is shown instead of the run.
    void recordingShown();
    /// The run is shown again.
    void liveShown();
    /// A user can change scene and knobs, or no longer.
    void changesAllowed(bool allowed);
    /// Knobs are shown as they are now; they may be others.
    void knobsShown();
    /// The model of the run is known: what its scene requires.
    void modelFitted();

private:
    void addEntries();
    void resetFault();
    void begin(LoadedScene scene, const Vector3& start, const Settings& settings);
    void rebuild(LoadedScene scene, const Vector3& start, const Settings& settings);
    [[nodiscard]] bool forcesMayAct();
    /// All that must be done before the run, or its scene, goes.
    void leave();
    void leaveRecording();
    void refuseTip(const QString& why);

    Host& host_;
    LivePanels& live_;
    QAction* forcesOff_ = nullptr;
    QAction* tipControl_ = nullptr;
    QAction* clutch_ = nullptr;
    TickSink sink_ = [](const TickSample&) {};
    std::unique_ptr<LiveRun> run_;
    SteadyForce steady_;
    Snapshot latest_;                          ///< as it is shown
    std::optional<ShownRecording> recording_;  ///< none: the run is shown
    bool wasRunning_ = false;                  ///< the run, before the recording
    std::vector<SetAside> setAsides_;
    std::vector<std::function<void()>> putBacks_;  ///< of the recording
    QString tipRefusal_;
    QString fixedBy_;
    bool forcesStayOff_ = false;
    bool isRecorded_ = false;
    const DeviceDriver* driver_ = nullptr;
    std::string scan_;  ///< of the last run
    bool isOnOtherScan_ = false;
};

/// Returns the folder for what the program writes for the user, among the user's documents.
[[nodiscard]] std::filesystem::path userFolder();

}  // namespace asperity
