#pragma once

#include "app/recording/LastSeconds.h"
#include "app/recording/RecordingRecovery.h"
#include "app/recording/RunRecording.h"
#include "app/session/RunControl.h"

#include <future>
#include <vector>

namespace asperity {

/// What a run leaves in files: recordings that a user asks for, and the last seconds before a
/// fault. They go to a folder each, named by date and time.
class RecordingControl : public QObject {
    Q_OBJECT

public:
    RecordingControl(MainWindow& window, RunControl& runs);

    /// Every tick from now on is written to a folder, until finish() or the run's end. There is a
    /// run.
    void start(const RecordingPlace& place);
    /// Where it is to be compact it is packed in the background: finished() comes later.
    void finish();
    /// Whether ticks of the run are being written, as they come or the last seconds.
    [[nodiscard]] bool isWriting() const { return recording_ || lastSeconds_.valid(); }
    [[nodiscard]] bool isPacking() const { return packing_.valid(); }
    /// Every tick, in order.
    void take(const TickSample& sample);
    /// Once a frame, after its ticks: ends what must end, saves what must be saved. There is a run.
    void advance();

    /// Why the last recording could not be written on; empty: it could.
    [[nodiscard]] const QString& failure() const { return failure_; }
    /// Processor time that it took to write a tick of the last recording; 0: there is none [s].
    [[nodiscard]] double writingTime() const { return writingTime_; }

    void setFolder(const std::filesystem::path& folder) { folder_ = folder; }
    /// Ends the recordings in the folder that were cut off at their last whole tick, in the
    /// background, and says so.
    void recoverCutOff();

Q_SIGNALS:
    /// Whatever ended it: what was written of it is in the folder.
    void finished(QString folder);
    void lastSecondsSaved(QString folder);
    void lastSecondsLost();  ///< they are not saved: the window has said why

private:
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

    MainWindow& window_;
    RunControl& runs_;
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

}  // namespace asperity
