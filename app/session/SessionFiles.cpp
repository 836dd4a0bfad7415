// What a session reads from files and leaves in them: scenes, recordings, pictures.

#include "app/session/Session.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/LoadingBar.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDateTime>
#include <QPixmap>
#include <QStandardPaths>

#include <chrono>
#include <utility>

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

}  // namespace

QString Session::reasonOf(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return tr("out of memory");
    } catch (const std::exception& known) {
        return QString::fromStdString(printable(known.what()));
    }
}

void Session::connectLoader() {
    connect(&loader_, &SceneLoader::progressed, &window_.loading(), &LoadingBar::setFraction);
    connect(&loader_, &SceneLoader::loaded, this,
            [this](const std::shared_ptr<LoadedScene>& scene) { onLoaded(*scene); });
    connect(&loader_, &SceneLoader::failed, this, &Session::onLoadFailed);
    connect(&window_, &MainWindow::cancelLoadingRequested, this, &Session::cancelOpen);
}

void Session::open(const std::filesystem::path& input) {
    loading_ = QString::fromStdString(printable(input.filename().string()));
    window_.showLoading(loading_);
    loader_.load(input);
}

void Session::cancelOpen() {
    if (loading_.isEmpty()) {
        return;
    }
    loader_.cancel();
    window_.showLoading({});
    window_.tell(tr("Loading of %1 cancelled").arg(std::exchange(loading_, {})));
    Q_EMIT openCancelled();
}

void Session::onLoaded(LoadedScene& scene) {
    loading_.clear();
    window_.showLoading({});
    use(std::move(scene));
}

void Session::onLoadFailed(const std::exception_ptr& error) {
    loading_.clear();
    window_.showLoading({});
    openError_ = error;
    const QString reason = reasonOf(error);
    window_.complain(reason);
    Q_EMIT openFailed(reason);
}

std::filesystem::path Session::standardRecordingsFolder() {
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return std::filesystem::path(documents.toStdString()) / "Asperity";
}

void Session::record(bool on) {
    if (on && run_) {
        startRecording({folderOfThisMoment(recordings_)});
    } else {
        finishRecording();
    }
}

void Session::startRecording(const RecordingPlace& place) {
    recordingFailure_.clear();
    fetchTicks();  // those before the recording belong to nobody
    const Snapshot before = run_->loop().snapshot();
    recordedAfter_ = before.statistics.ticks > 0 ? before.sample.time : -1.0;
    try {
        recording_ = std::make_unique<RecordingThread>(place, run_->loaded(), before.memory,
                                                       run_->hand().delay());
    } catch (const std::exception& error) {
        recordingFailure_ = QString::fromUtf8(error.what());
        window_.complain(recordingFailure_);
    }
    showRecording();
}

void Session::finishRecording() {
    if (recording_) {
        fetchTicks();
        const std::unique_ptr<RecordingThread> finished = std::move(recording_);
        try {
            finished->finish();
            writingTime_ = finished->timePerTick();
            tellOfRecording(*finished);
        } catch (const std::exception& error) {
            recordingFailure_ = QString::fromUtf8(error.what());
            window_.complain(tr("The recording has ended: %1. What was written until then is kept, "
                                "and can be replayed.")
                                 .arg(recordingFailure_));
        }
        Q_EMIT recordingFinished(QString::fromStdString(finished->folder().string()));
    }
    showRecording();
}

void Session::tellOfRecording(const RecordingThread& recording) {
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

void Session::recoverCutOff() {
    recovered_ = std::async(std::launch::async, recoverRecordings, recordings_);
}

/// Once a scene is there: its name would be told over it.
void Session::tellOfRecovered() {
    using namespace std::chrono_literals;
    if (!recovered_.valid() || recovered_.wait_for(0s) != std::future_status::ready) {
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
                         .arg(QString::fromStdString(recordings_.string())));
    }
}

void Session::saveLastSeconds() {
    using namespace std::chrono_literals;
    if (lastSeconds_.valid() && lastSeconds_.wait_for(0s) == std::future_status::ready) {
        finishLastSeconds();
    }
    if (!run_->blackBox().frozen() || lastSeconds_.valid()) {
        return;
    }
    try {
        BlackBox box = run_->blackBox().release();
        if (box.samples().empty()) {
            window_.tell(tr("There are no last seconds to save yet"));
        } else {
            lastSeconds_ = writeLastSeconds(folderOfThisMoment(recordings_), run_->loaded(),
                                            std::move(box), run_->hand().delay());
        }
    } catch (const std::exception& error) {
        window_.complain(tr("The last seconds are not saved: %1").arg(error.what()));
    }
}

void Session::finishLastSeconds() {
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
        window_.complain(tr("The last seconds are not saved: %1").arg(error.what()));
    }
}

void Session::saveRun() {
    if (run_) {
        run_->loop().stop();
        fetchTicks();
        finishRecording();
        finishLastSeconds();
        saveLastSeconds();
        finishLastSeconds();
    }
}

void Session::showRecording() {
    window_.controls().setRecording(recording_ != nullptr);
    window_.menus().record->setChecked(recording_ != nullptr);
}

void Session::savePicture(const QString& file) {
    if (run_) {
        fetchTicks();
        show_.showEverywhere(run_->loop().snapshot());
    }
    if (window_.grab().save(file)) {
        window_.tell(tr("Saved as %1").arg(file));
    } else {
        window_.complain(tr("%1: the picture cannot be written").arg(file));
    }
}

}  // namespace asperity
