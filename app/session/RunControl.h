#pragma once

#include "app/runs/LiveRun.h"

#include <QObject>
#include <QString>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace asperity {

class MainWindow;

/// The run behind the window: begins and ends it, lets it pause and go on, turns its knobs.
class RunControl : public QObject {
    Q_OBJECT

public:
    explicit RunControl(MainWindow& window);

    /// The present run; null before the first scene.
    [[nodiscard]] LiveRun* run() const { return run_.get(); }
    /// Who gets every tick, in order.
    void setSink(TickSink sink) { sink_ = std::move(sink); }
    /// Passes all ticks of the run since the last time to the sink. There is a run.
    void fetch() { run_->fetch(sink_); }

    /// Shows a scene that is loaded, and starts its loop. Forces that are off, or that a fault
    /// keeps away, stay off. @param place above which the tip waits, where that is on the scan [m]
    void use(LoadedScene scene, const std::optional<Vector2>& place = std::nullopt);
    /// The loop begins again above the same place, or another one, with the same knobs, on the
    /// scene changed. There is a run. @param place world [m]
    void replace(LoadedScene scene, const std::optional<Vector2>& place = std::nullopt);
    /// The loop begins anew on a scene, with the base at a place and with these knobs; device and
    /// view stay. Forces that are off, or that a fault keeps away, stay off. There is a run.
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

    /// The tick that the window shows: of a recording that is looked at, else the latest one of the
    /// loop. There is a run.
    [[nodiscard]] const Snapshot& shown() {
        return recorded_ ? *recorded_ : run_->loop().snapshot();
    }
    /// The last seconds up to that tick, in order. There is a run.
    [[nodiscard]] std::vector<TickSample> shownTicks();
    [[nodiscard]] bool showsRecording() const { return recorded_.has_value(); }
    /// Shows the last one of these ticks of a recording. @param goesOn they follow those before
    void showRecorded(std::span<const TickSample> ticks, bool goesOn);
    /// Shows the ticks of the loop again.
    void showLive();

    /// Nobody moves the tip of the run meanwhile. @param why for tool tips; empty: it can be moved
    void refuseTip(const QString& why);
    [[nodiscard]] const QString& tipRefusal() const { return tipRefusal_; }

    /// Nobody but who fixed them changes scene and knobs meanwhile. @param why for tool tips;
    /// empty: they are the user's again
    void fix(const QString& why);
    /// Nobody switches forces on while scene and knobs are fixed.
    void keepForcesOff() { forcesStayOff_ = true; }
    [[nodiscard]] const QString& fixedBy() const { return fixedBy_; }

Q_SIGNALS:
    /// The run is about to go. Its loop rests, and all of its ticks are fetched.
    void ending();
    /// Another run is there and shown; its loop does not run yet.
    void begun();
    /// After begun(): its scene is the one before, changed.
    void rebuilt();
    /// The loop begins, or goes on.
    void started();
    /// The model of the run is known: what its scene requires.
    void modelFitted();

private:
    void begin(LoadedScene scene, const Vector3& start, const Settings& settings);
    void rebuild(LoadedScene scene, const Vector3& start, const Settings& settings);
    [[nodiscard]] bool forcesMayAct();
    /// All that must be done before the run, or its scene, goes.
    void leave();

    MainWindow& window_;
    TickSink sink_ = [](const TickSample&) {};
    std::unique_ptr<LiveRun> run_;
    std::optional<Snapshot> recorded_;      ///< none: the loop's ticks are shown
    std::deque<TickSample> recordedTicks_;  ///< the last seconds up to it
    QString tipRefusal_;
    QString fixedBy_;
    bool forcesStayOff_ = false;
};

}  // namespace asperity
