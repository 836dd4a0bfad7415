#include "app/session/BundleControl.h"

#include "app/recording/Bundle.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrivateFolder.h"
#include "ui/ShownPath.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QImage>
#include <QPixmap>

#include <utility>

namespace asperity {

namespace {

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

BundleControl::BundleControl(MainWindow& window, RunControl& runs, RecordingControl& recordings,
                             ViewControl& views)
    : window_(window)
    , runs_(runs)
    , recordings_(recordings)
    , views_(views)
    , work_(loadingLine(window),
            {.finished =
                 [this](const std::filesystem::path& file) {
                     const QString name = shownPath(file);
                     window_.tell(
                         tr("Bundled in %1: it opens and replays on any machine").arg(name));
                     Q_EMIT bundled(name);
                 },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     window_.complain(tr("There is no bundle: %1").arg(reasonOf(reason)));
                 }}) {
    connect(window.menus().bundle, &QAction::triggered, this, qOverload<>(&BundleControl::bundle));
    connect(&recordings, &RecordingControl::finished, this, [this](const QString& folder) {
        last_ = folder;
        if (std::exchange(isAwaited_, false)) {
            bundle(folder);
        }
    });
    connect(&recordings, &RecordingControl::lastSecondsLost, this, [this] { isAwaited_ = false; });
    connect(&recordings, &RecordingControl::lastSecondsSaved, this, [this](const QString& folder) {
        if (std::exchange(isAwaited_, false)) {
            bundle(folder);
        }
    });
    connect(&runs, &RunControl::begun, this, [this] { last_.clear(); });
}

void BundleControl::bundle() {
    if (runs_.run() == nullptr || work_.isAwaited()) {
        return;
    }
    recordings_.finish();  // where one goes on, that is what the user has in mind
    isAwaited_ = recordings_.isPacking();
    if (isAwaited_) {
        return;
    }
    if (!last_.isEmpty()) {
        bundle(last_);
        return;
    }
    isAwaited_ = true;
    window_.menus().saveLastSeconds->trigger();
}

void BundleControl::bundle(const QString& folder) {
    const std::filesystem::path run = folder.toStdString();
    const std::filesystem::path file = freeFile(run);
    const QImage picture = views_.picture().toImage();
    work_.start(tr("Bundling %1 …").arg(shownPath(file)), [run, file, picture](Progress& progress) {
        write(run, picture, file, progress);
        return file;
    });
}

}  // namespace asperity
