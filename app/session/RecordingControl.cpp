#include "app/session/RecordingControl.h"

#include "app/recording/RunPacking.h"
#include "app/session/UserFolder.h"
#include "ui/panels/ControlBar.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDateTime>

#include <chrono>

namespace asperity {

namespace {

/// One that is not there yet.
std::filesystem::path folderOfThisMoment(const std::filesystem::path& parent) {
    const auto named = [&parent](const QDateTime& time) {
        return parent / time.toString("yyyy-MM-dd_HH-mm-ss.zzz").toStdString();
    };
    QDateTime now = QDateTime::currentDateTime();
    std::error_code unknown;
    while (std::filesystem::exists(named(now), unknown)) {
        now = now.addMSecs(1);
    }
    return named(now);
}

template <typename Result>
bool isReady(const std::future<Result>& result) {
    using namespace std::chrono_literals;
    return result.valid() && result.wait_for(0s) == std::future_status::ready;
}

}  // namespace

RecordingControl::RecordingControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs), folder_(userFolder()) {
    connect(&window.controls(), &ControlBar::recordingChosen, this, &RecordingControl::record);
    connect(window.menus().record, &QAction::triggered, this, &RecordingControl::record);
    connect(window.menus().saveLastSeconds, &QAction::triggered, this, [this] {
        if (runs_.run() != nullptr) {
            runs_.fetch();
            runs_.run()->blackBox().freeze();
        }
    });
    connect(&runs, &RunControl::ending, this, &RecordingControl::saveAll);
    connect(&runs, &RunControl::begun, this, &RecordingControl::tellOfCutRecording);
}

void RecordingControl::take(const TickSample& sample) {
    if (recording_) {
        recording_->take(sample);
    }
}

void RecordingControl::advance() {
    saveLastSeconds();
    tellOfRecovered();
    if (isReady(packing_)) {
        tellOfPacked();
    }
    if (recording_ && recording_->thread().end() != RecordingEnd::None) {
        finish();
    }
}

void RecordingControl::record(bool on) {
    if (on && runs_.run() != nullptr) {
        const bool isCompact = window_.menus().compactRecordings->isChecked();
        start({.folder = folderOfThisMoment(folder_),
               .format = isCompact ? RunFormat::Hdf5 : RunFormat::Csv});
    } else {
        finish();
    }
}

void RecordingControl::start(const RecordingPlace& place) {
    failure_.clear();
    runs_.fetch();  // those before the recording belong to nobody
    try {
        // Packing takes seconds, and whoever finishes a recording waits for its end.
        const RecordingPlace text{.folder = place.folder, .replace = place.replace};
        recording_ = std::make_unique<RunRecording>(text, *runs_.run());
        format_ = place.format;
    } catch (const std::exception& error) {
        failure_ = QString::fromUtf8(error.what());
        window_.complain(failure_);
    }
    show();
}

void RecordingControl::finish() {
    if (recording_) {
        runs_.fetch();
        const std::unique_ptr<RunRecording> recording = std::move(recording_);
        RecordingThread& ended = recording->thread();
        try {
            ended.finish();
            writingTime_ = ended.timePerTick();
            tellOf(ended);
        } catch (const std::exception& error) {
            failure_ = QString::fromUtf8(error.what());
            window_.complain(tr("The recording has ended: %1. What was written until then is kept, "
                                "and can be replayed.")
                                 .arg(failure_));
        }
        const QString folder = QString::fromStdString(ended.folder().string());
        if (format_ == RunFormat::Hdf5 && failure_.isEmpty() && ended.ticks() > 0) {
            tellOfPacked();  // one at a time
            packed_ = folder;
            packing_ = std::async(std::launch::async, packRun, ended.folder());
        } else {
            Q_EMIT finished(folder);
        }
    }
    show();
}

/// Waits where it is not packed yet.
void RecordingControl::tellOfPacked() {
    if (!packing_.valid()) {
        return;
    }
    try {
        packing_.get();
        window_.tell(tr("The recording in %1 is packed").arg(packed_));
    } catch (const std::exception& error) {
        window_.complain(
            tr("The recording in %1 stays text: %2").arg(packed_, QString::fromUtf8(error.what())));
    }
    Q_EMIT finished(packed_);
}

void RecordingControl::tellOf(const RecordingThread& recording) {
    const QString folder = QString::fromStdString(recording.folder().string());
    window_.tell(tr("%1 ticks recorded in %2").arg(recording.ticks()).arg(folder));
    if (recording.end() == RecordingEnd::TicksLost) {
        window_.complain(tr("The window was busy for so long that ticks were lost. The recording "
                            "in %1 ends before them.")
                             .arg(folder));
    } else if (recording.end() == RecordingEnd::DiskTooSlow) {
        window_.complain(tr("The disk cannot write as fast as the loop runs. The recording in %1 "
                            "ends where it fell behind.")
                             .arg(folder));
    }
}

void RecordingControl::recoverCutOff() {
    recovered_ = std::async(std::launch::async, recoverRecordings, folder_);
}

/// Once a scene is there: its name would be told over it.
void RecordingControl::tellOfRecovered() {
    if (!isReady(recovered_)) {
        return;
    }
    const std::vector<RecoveredRecording> recordings = recovered_.get();
    for (const RecoveredRecording& recording : recordings) {
        const QString folder = QString::fromStdString(recording.folder.string());
        window_.tell(recording.problem.empty()
                         ? tr("A recording that was cut off is kept: %1 s in %2")
                               .arg(recording.duration, 0, 'f', 1)
                               .arg(folder)
                         : tr("A recording that was cut off is not kept: %1")
                               .arg(QString::fromUtf8(recording.problem.c_str())));
    }
    if (recordings.size() > 1) {
        window_.tell(tr("%1 recordings that were cut off are kept in %2")
                         .arg(recordings.size())
                         .arg(QString::fromStdString(folder_.string())));
    }
}

void RecordingControl::saveLastSeconds() {
    if (isReady(lastSeconds_)) {
        finishLastSeconds();
    }
    LiveRun& run = *runs_.run();
    if (!run.blackBox().frozen() || lastSeconds_.valid()) {
        return;
    }
    try {
        BlackBox box = run.blackBox().release();
        if (box.samples().empty()) {
            window_.tell(tr("The black box is still empty"));
            Q_EMIT lastSecondsLost();
        } else {
            lastSeconds_ = writeLastSeconds(folderOfThisMoment(folder_), run.loaded(),
                                            std::move(box), run.device().delay());
        }
    } catch (const std::exception& error) {
        window_.complain(tr("The last 10 s are not saved: %1").arg(error.what()));
        Q_EMIT lastSecondsLost();
    }
}

void RecordingControl::finishLastSeconds() {
    if (!lastSeconds_.valid()) {
        return;
    }
    try {
        const LastSeconds written = lastSeconds_.get();
        const QString folder = QString::fromStdString(written.folder.string());
        const QString saved =
            tr("the last %1 ticks are saved in %2").arg(written.ticks).arg(folder);
        window_.tell(written.fault == Fault::None
                         ? saved
                         : tr("Fault %1: %2").arg(keyOf(written.fault), saved));
        Q_EMIT lastSecondsSaved(folder);
    } catch (const std::exception& error) {
        window_.complain(tr("The last 10 s are not saved: %1").arg(error.what()));
        Q_EMIT lastSecondsLost();
    }
}

void RecordingControl::saveAll() {
    cut_ = recording_ ? QString::fromStdString(recording_->thread().folder().string()) : QString();
    finish();
    finishLastSeconds();
    saveLastSeconds();
    finishLastSeconds();
}

void RecordingControl::tellOfCutRecording() {
    if (!cut_.isEmpty()) {
        window_.tell(tr("The scene changed: the recording in %1 has ended").arg(cut_));
    }
}

void RecordingControl::show() {
    window_.controls().setRecording(recording_ != nullptr);
    window_.menus().record->setChecked(recording_ != nullptr);
}

}  // namespace asperity
