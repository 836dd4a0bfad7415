#pragma once

#include "app/recording/LastSeconds.h"
#include "app/recording/RecordingRecovery.h"
#include "app/recording/RecordingThread.h"
#include "app/session/FidelityStudy.h"
#include "app/session/FrameShow.h"
#include "app/session/HandControl.h"
#include "app/session/LiveRun.h"
#include "app/session/SceneLoader.h"

#include <QObject>
#include <QTimer>

#include <exception>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

class MainWindow;
class HeldKeys;

/// Wires the window to the run behind it: panels' signals to the loop's knobs, ticks to the panels.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(MainWindow& window);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Loads in the background, then shows; says so in the window when that fails. Another one that
    /// is being loaded is given up.
    void open(const std::filesystem::path& input);
    /// Gives up what is being loaded; the scene stays as it is.
    void cancelOpen();
    /// Why the last scene that failed to open did so; null: none did.
    [[nodiscard]] std::exception_ptr openError() const { return openError_; }
    /// Shows a scene that is loaded, and starts its loop.
    void use(LoadedScene scene);

    /// The hand follows a path of the base from its start.
    void follow(const HandPath& path);
    /// A person at the simulated device leads the base along a path from its start.
    void leadDevice(const HandPath& path);
    void start();
    void pause();
    /// Every tick from now on is written to a folder, until finishRecording() or the run's end.
    void startRecording(const RecordingPlace& place);
    void finishRecording();
    /// Why the last recording could not be written on; empty: it could.
    [[nodiscard]] const QString& recordingFailure() const { return recordingFailure_; }
    /// Ends the recordings in the recordings' folder that were cut off at their last whole tick, in
    /// the background, and says so.
    void recoverCutOff();
    /// Processor time that it took to write a tick of the last recording; 0: there is none [s].
    [[nodiscard]] double writingTime() const { return writingTime_; }

    /// The present run; null before the first scene.
    [[nodiscard]] LiveRun* run() { return run_.get(); }
    /// Frames a second of each view since the window was opened.
    [[nodiscard]] std::vector<ViewRate> viewRates() const { return show_.rates(); }
    /// Where recordings go: a folder each, named by date and time.
    void setRecordingsFolder(const std::filesystem::path& folder) { recordings_ = folder; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// Another scene is shown.
    void sceneShown();
    void openFailed(QString reason);
    void openCancelled();
    /// Whatever ended it: what was written of it is in the folder.
    void recordingFinished(QString folder);
    void lastSecondsSaved(QString folder);

private:
    [[nodiscard]] static std::filesystem::path standardRecordingsFolder();
    [[nodiscard]] static QString reasonOf(const std::exception_ptr& error);

    void connectControls();
    void connectMenus();
    void connectHandMenu();
    void connectViews();
    void connectLoader();
    void connectFidelity();
    void fillChoices();

    void onLoaded(LoadedScene& scene);
    void onLoadFailed(const std::exception_ptr& error);
    void begin(LoadedScene scene, const Vector3& start, const Settings& settings);
    void endRun();
    /// Fetches and saves all that the run still holds, before it goes.
    void saveRun();
    /// The loop begins again above the same place, with the same knobs, on the scene changed.
    /// Forces that are off, or that a fault keeps away, stay off over another scene.
    [[nodiscard]] bool forcesMayAct();
    void rebuild(const std::function<LoadedScene(LoadedScene)>& change);
    void chooseMaterial(int index);
    void chooseModel(const SceneDescription& choices);
    void pickTier(const ForceModelOptions& tier);
    void measureFidelity();
    /// Makes sure that a hand with motors could hold the tip of this. @throw Error
    void requireHolding(const SceneDescription& scene) const;
    void chooseHand(int index);
    /// A device that leads, to be taken up again on another scene; `Other`: none does.
    struct LedDevice {
        HandKind kind = HandKind::Other;
        HandScale scale;
    };
    [[nodiscard]] LedDevice ledDevice() const;
    void takeUp(const LedDevice& device);
    void followDelay();
    void choosePath(int index);
    void chooseGuide(FixtureKind kind);
    /// Turns the axes of a device with the view, where that is wanted.
    void turnHand(double seconds);
    void turnKnob(const QString& column, double value);
    using ReadPath = std::function<HandPath(const std::filesystem::path&)>;
    bool followFile(const QString& file, const ReadPath& read);
    void repeatRecording(const std::filesystem::path& forceLog);
    void travelTo(const Vector2& place);
    void changeSettings(const std::function<void(Settings&)>& change);
    void setForces(bool on);
    void takeBackFault();
    void record(bool on);
    void tellOfRecording(const RecordingThread& recording);
    void tellOfRecovered();
    /// Begins to write what the black box holds, as soon as nothing else of it is being written.
    void saveLastSeconds();
    /// Waits until they are written.
    void finishLastSeconds();
    void savePicture(const QString& file);

    void onFrame();
    void solveHalfSpace(const Snapshot& latest);
    void moveHand(double seconds);
    void fetchTicks();
    void showKnobs();
    void showHand();
    void tellOfHand();
    void showRecording();
    void showFidelity();

    MainWindow& window_;
    FrameShow show_;
    HeldKeys* keys_;
    SceneLoader loader_;
    FidelityStudy study_;
    QTimer frames_;
    std::unique_ptr<LiveRun> run_;
    HandControl hand_;
    std::unique_ptr<RecordingThread> recording_;
    std::future<LastSeconds> lastSeconds_;                    ///< being written; not valid: none
    std::future<std::vector<RecoveredRecording>> recovered_;  ///< not valid: nothing to tell of
    QString recordingFailure_;
    double recordedAfter_ = 0.0;  ///< what came until then is not of the recording [s]
    double writingTime_ = 0.0;    ///< [s]
    std::filesystem::path recordings_;
    std::vector<SampleMaterial> materials_;
    QString loading_;  ///< name of the file that is being loaded; empty: none
    std::exception_ptr openError_;
    std::string deviceStatus_;  ///< as told last
    double lastFrame_ = 0.0;    ///< [s]
};

}  // namespace asperity
