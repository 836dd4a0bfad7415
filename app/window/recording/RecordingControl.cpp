#include "app/window/recording/RecordingControl.h"

#include "app/loading/ComparedRun.h"
#include "app/recording/Bundle.h"
#include "app/recording/RunPacking.h"
#include "app/runs/RunFolder.h"
#include "app/window/RunControl.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QDateTime>
#include <QImage>
#include <QPixmap>

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

template <typename Result>
bool isReady(const std::future<Result>& result) {
    using namespace std::chrono_literals;
    return result.valid() && result.wait_for(0s) == std::future_status::ready;
}

}  // namespace

RecordingControl::RecordingControl(Stage& stage) : Feature(stage), folder_(userFolder()) {
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Act, [this](double /*elapsed*/) { advance(); });
    connect(&live_.controls(), &ControlBar::recordingChosen, this, &RecordingControl::record);
    addEntries();
    connect(&runs_, &RunControl::ending, this, &RecordingControl::saveAll);
    connect(&runs_, &RunControl::begun, this, &RecordingControl::tellOfCutRecording);
    host_.askBeforeClosing([this] {
        return recording_ ? tr("A recording is being written: it ends, and is kept.") : QString();
    });
}

void RecordingControl::addEntries() {
    Menus& menus = host_.menus();
    record_ = &menus.add({MenuName::File, 1, 30}, "record",
                         {.text = tr("&Record"),
                          .tip = tr("Write every tick to a folder, until it is chosen again"),
                          .shortcuts = {tr("Ctrl+R")},
                          .isCheckable = true,
                          .refusal = [this] { return runs_.changeRefusal(); }});
    compact_ = &menus.add({MenuName::File, 1, 40}, "compactRecordings",
                          {.text = tr("Compact recordin&gs (HDF5)"),
                           .tip = tr("Recordings are packed at their end into an HDF5 file of a "
                                     "tenth of the size, for Python, which replays as well"),
                           .isCheckable = true,
                           .keptAs = QStringLiteral("recordings/compact")});
    const QAction& lastSeconds =
        menus.add({MenuName::File, 1, 50}, "saveLastSeconds",
                  {.text = tr("Save the &last 10 s (black box)"),
                   .tip = tr("Save the last 10 s of the run as a recording"),
                   .refusal = [this] { return runs_.showRefusal(); }});
    connect(record_, &QAction::triggered, this, &RecordingControl::record);
    connect(&lastSeconds, &QAction::triggered, this, &RecordingControl::freezeLastSeconds);
}

void RecordingControl::freezeLastSeconds() {
    if (runs_.run() != nullptr) {
        runs_.fetch();
        runs_.run()->blackBox().freeze();
    }
}

void RecordingControl::take(const TickSample& sample) {
    if (recording_) {
        recording_->take(sample);
    }
}

void RecordingControl::advance() {
    saveLastSeconds();
    runs_.setRecorded(isWriting());
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
        start({.folder = folderOfThisMoment(folder_),
               .format = compact_->isChecked() ? RunFormat::Hdf5 : RunFormat::Csv});
    } else {
        finish();
    }
}

void RecordingControl::start(const RecordingTarget& target) {
    failure_.clear();
    runs_.fetch();  // those before the recording belong to nobody
    try {
        // Packing takes seconds, and whoever finishes a recording waits for its end.
        const RecordingTarget text{.folder = target.folder, .replace = target.replace};
        recording_ = std::make_unique<RunRecording>(text, *runs_.run());
        format_ = target.format;
    } catch (const std::exception& error) {
        failure_ = QString::fromUtf8(error.what());
        host_.complain(failure_);
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
            host_.complain(tr("The recording has ended: %1. What was written until then is kept, "
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
        host_.tell(tr("The recording in %1 is packed").arg(packed_));
    } catch (const std::exception& error) {
        host_.complain(
            tr("The recording in %1 stays text: %2").arg(packed_, QString::fromUtf8(error.what())));
    }
    Q_EMIT finished(packed_);
}

void RecordingControl::tellOf(const RecordingThread& recording) {
    const QString folder = QString::fromStdString(recording.folder().string());
    host_.tell(tr("%1 ticks recorded in %2").arg(recording.ticks()).arg(folder));
    if (recording.end() == RecordingEnd::TicksLost) {
        host_.complain(tr("The window was busy for so long that ticks were lost. The recording "
                          "in %1 ends before them.")
                           .arg(folder));
    } else if (recording.end() == RecordingEnd::DiskTooSlow) {
        host_.complain(tr("The disk cannot write as fast as the loop runs. The recording in %1 "
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
        host_.tell(recording.problem.empty()
                       ? tr("Recovered a recording that was cut off: %1 s in %2")
                             .arg(recording.duration, 0, 'f', 1)
                             .arg(folder)
                       : tr("Could not recover a recording that was cut off: %1")
                             .arg(QString::fromUtf8(recording.problem.c_str())));
    }
    if (recordings.size() > 1) {
        host_.tell(tr("Recovered %1 recordings that were cut off, in %2")
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
            host_.tell(tr("The black box is still empty"));
            Q_EMIT lastSecondsLost();
        } else {
            lastSeconds_ = writeLastSeconds(folderOfThisMoment(folder_), run.loaded(),
                                            std::move(box), run.device().delay());
        }
    } catch (const std::exception& error) {
        host_.complain(tr("The last 10 s are not saved: %1").arg(error.what()));
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
        host_.tell(written.fault == Fault::None
                       ? saved
                       : tr("Fault %1: %2").arg(keyOf(written.fault), saved));
        Q_EMIT lastSecondsSaved(folder);
    } catch (const std::exception& error) {
        host_.complain(tr("The last 10 s are not saved: %1").arg(error.what()));
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
        host_.tell(tr("The scene changed: the recording in %1 has ended").arg(cut_));
    }
}

void RecordingControl::show() {
    runs_.setRecorded(isWriting());
    live_.controls().setRecording(recording_ != nullptr);
    record_->setChecked(recording_ != nullptr);
}

namespace {

QString nameOfRun(const QString& folder) {
    return BundleControl::tr("Recording %1")
        .arg(QString::fromStdString(runName(folder.toStdString())));
}

/// Beside the run's folder; no other file goes.
std::filesystem::path freeFile(const std::filesystem::path& run) {
    std::filesystem::path file = run.string() + ".zip";
    for (int i = 2; isThere(file); ++i) {
        file = run.string() + "_" + std::to_string(i) + ".zip";
    }
    return file;
}

void write(const std::filesystem::path& run, const QImage& picture,
           const std::filesystem::path& file, Progress& progress) {
    const PrivateFolder scratch;
    const std::filesystem::path drawn = scratch.path() / "picture.png";
    if (!picture.save(QString::fromStdString(drawn.string()))) {
        throw Error(drawn.string() + ": the picture cannot be written");
    }
    writeBundle(run, drawn, file, &progress);
}

}  // namespace

BundleControl::BundleControl(Stage& stage)
    : Feature(stage)
    , recordings_(stage.get<RecordingControl>())
    , playback_(stage.get<PlaybackControl>())
    , views_(stage.get<ViewControl>())
    , work_(loadingLine(host_),
            {.finished =
                 [this](const Bundled& made) {
                     const QString name = shownPath(made.file);
                     host_.tell(tr("%1: bundled in %2, which opens and replays on any machine")
                                    .arg(made.subject, name));
                     Q_EMIT bundled(name);
                 },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     host_.complain(tr("There is no bundle: %1").arg(reasonOf(reason)));
                 }}) {
    const QAction& entry =
        host_.menus().add({MenuName::File, 1, 60}, "bundle",
                          {.text = tr("B&undle a recording"),
                           .tip = tr("Put the recording that is open, else the last one, or the "
                                     "last 10 s, with scan and picture into one file (.zip), "
                                     "which opens and replays on any machine"),
                           .shortcuts = {tr("Ctrl+B")},
                           .refusal = [this] { return runs_.showRefusal(); }});
    connect(&entry, &QAction::triggered, this, qOverload<>(&BundleControl::bundle));
    connect(&recordings_, &RecordingControl::finished, this, [this](const QString& folder) {
        last_ = folder;
        if (std::exchange(isAwaited_, false)) {
            bundle(folder, nameOfRun(folder));
        }
    });
    connect(&recordings_, &RecordingControl::lastSecondsLost, this, [this] { isAwaited_ = false; });
    connect(&recordings_, &RecordingControl::lastSecondsSaved, this, [this](const QString& folder) {
        if (std::exchange(isAwaited_, false)) {
            bundle(folder, tr("The last 10 s"));
        }
    });
    connect(&runs_, &RunControl::begun, this, [this] { last_.clear(); });
}

void BundleControl::bundle() {
    if (runs_.run() == nullptr || work_.isAwaited()) {
        return;
    }
    if (playback_.isReading()) {
        host_.tell(tr("A recording is being opened: bundle it once it is shown"));
        return;
    }
    if (runs_.showsRecording()) {
        bundleOpen();
        return;
    }
    recordings_.finish();  // where one goes on, that is what the user has in mind
    isAwaited_ = recordings_.isPacking();
    if (isAwaited_) {
        return;
    }
    if (last_.isEmpty()) {
        bundleLastSeconds();
    } else {
        bundle(last_, nameOfRun(last_));
    }
}

/// The last seconds that are played again are still in the black box: the run rests.
void BundleControl::bundleOpen() {
    const std::filesystem::path open = runs_.openRecording();
    if (open.empty()) {
        bundleLastSeconds();
    } else if (isBundle(open)) {
        host_.tell(tr("%1 is a bundle already").arg(shownPath(open)));
    } else {
        const QString folder = QString::fromStdString(open.string());
        bundle(folder, nameOfRun(folder));
    }
}

void BundleControl::bundleLastSeconds() {
    isAwaited_ = true;
    recordings_.freezeLastSeconds();
}

void BundleControl::bundle(const QString& folder, const QString& subject) {
    const std::filesystem::path run = folder.toStdString();
    const std::filesystem::path file = freeFile(run);
    const QImage picture = views_.picture().toImage();
    work_.start(tr("%1: bundling in %2 …").arg(subject, shownPath(file)),
                [run, file, picture, subject](Progress& progress) {
                    write(run, picture, file, progress);
                    return Bundled{.subject = subject, .file = file};
                });
}

}  // namespace asperity
