#pragma once

#include "app/recording/RecordingRecovery.h"
#include "app/recording/RunRecording.h"
#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/recording/PlaybackControl.h"

#include <QString>

#include <filesystem>
#include <future>
#include <vector>

class QAction;

namespace asperity {

/// Writes the files of a run: recordings that a user asks for, and the last seconds before a fault.
/// Each is in a folder of its own, named by date and time.
class RecordingControl : public Feature {
    Q_OBJECT

public:
    explicit RecordingControl(Stage& stage);

    /// Every tick from now on is written to a folder, until finish() or the run's end. There is a
    /// run.
    void start(const RecordingTarget& target);
    /// Ends the recording. A compact one is packed in the background: finished() comes later.
    void finish();
    /// Returns whether ticks of the run are being written, as they come or the last seconds.
    [[nodiscard]] bool isWriting() const { return recording_ || lastSeconds_.valid(); }
    [[nodiscard]] bool isPacking() const { return packing_.valid(); }
    /// Every tick, in order.
    void take(const TickSample& sample);
    /// Once a frame, after its ticks: ends what must end, saves what must be saved. There is a run.
    void advance();

    /// Returns why the last recording could not be continued; empty: it could.
    [[nodiscard]] const QString& failure() const { return failure_; }
    /// Processor time that it took to write a tick of the last recording; 0: there is none [s].
    [[nodiscard]] double writingTime() const { return writingTime_; }

    void setFolder(const std::filesystem::path& folder) { folder_ = folder; }
    /// Ends the recordings in the folder that were cut off at their last whole tick, in the
    /// background, and says so.
    void recoverCutOff();
    /// Saves the last 10 s of the run, once they are all there, as a recording.
    void freezeLastSeconds();

Q_SIGNALS:
    /// Whatever ended it: what was written of it is in the folder.
    void finished(QString folder);
    void lastSecondsSaved(QString folder);
    void lastSecondsLost();  ///< they are not saved: the window has said why

private:
    void addEntries();
    void record(bool on);
    void show();
    void tellOf(const RecordingThread& recording);
    void tellOfPacked();
    void tellOfRecovered();
    /// Begins to write what the black box holds, as soon as nothing else of it is being written.
    void saveLastSeconds();
    /// Waits until they are written.
    void finishLastSeconds();
    /// All that the run still holds, before it goes.
    void saveAll();
    /// Over the name of the next scene.
    void tellOfCutRecording();

    QAction* record_ = nullptr;
    QAction* compact_ = nullptr;
    std::filesystem::path folder_;
    std::unique_ptr<RunRecording> recording_;
    RunFormat format_ = RunFormat::Csv;  ///< of the recording
    QString packed_;                     ///< folder of the recording that is being packed
    std::future<void> packing_;          ///< not valid: none is
    QString failure_;
    QString cut_;               ///< folder of the recording that the last change of scene ended
    double writingTime_ = 0.0;  ///< [s]
    std::future<LastSeconds> lastSeconds_;                    ///< being written; not valid: none
    std::future<std::vector<RecoveredRecording>> recovered_;  ///< not valid: nothing to tell of
};

/// One click puts the recording that is open, else the last one, or the last 10 s where there is
/// none, with its scan and a picture of the window into one file beside it.
class BundleControl : public Feature {
    Q_OBJECT

public:
    explicit BundleControl(Stage& stage);

Q_SIGNALS:
    void bundled(QString file);

private:
    /// A bundle, and what is in it for people.
    struct Bundled {
        QString subject;
        std::filesystem::path file;
    };

    void bundle();
    void bundleOpen();
    void bundleLastSeconds();
    void bundle(const QString& folder, const QString& subject);

    RecordingControl& recordings_;
    PlaybackControl& playback_;
    ViewControl& views_;
    QString last_;            ///< folder of the last recording of this run; empty: there is none
    bool isAwaited_ = false;  ///< what is to be bundled is being written
    LongWork<Bundled> work_;
};

}  // namespace asperity
