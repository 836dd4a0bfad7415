#include "app/session/SessionControl.h"

#include "app/session/WindowSection.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/TemporaryFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/SceneSaving.h"
#include "core/scene/SceneFiles.h"
#include "core/scene/SettingFields.h"
#include "ui/ShownPath.h"
#include "ui/window/LayoutMemory.h"
#include "ui/window/MainWindow.h"
#include "ui/window/ViewMemory.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QFile>
#include <QStandardPaths>

namespace asperity {

namespace {

constexpr int kKeepPeriod = 250;  // between two looks at what has changed [ms]
const QString kFile = QStringLiteral("session/file");

}  // namespace

SessionControl::SessionControl(MainWindow& window, RunControl& runs, SceneEdits& edits,
                               SceneControl& scenes, const PlaybackControl& playback)
    : window_(window), runs_(runs), edits_(edits), scenes_(scenes) {
    WindowMenus& menus = window.menus();
    connect(menus.saveSession, &QAction::triggered, this, &SessionControl::save);
    connect(&window, &MainWindow::sceneFileChosen, this,
            [this](const QString& file) { saveAs(pathOf(file)); });
    connect(&window, &MainWindow::sceneFileWanted, this, &SessionControl::suggestFile);
    connect(menus.restoreSession, &QAction::triggered, this,
            [this] { scenes_.open(folder_->before()); });
    connect(&scenes, &SceneControl::sceneTaken, this, &SessionControl::begin);
    connect(&scenes, &SceneControl::opened, this, [this](const std::filesystem::path& file) {
        names_[edits_.origin()] = file.stem().string();
    });
    connect(&scenes, &SceneControl::sessionOpened, this, &SessionControl::restore);
    connect(&due_, &QTimer::timeout, this, &SessionControl::keep);
    connect(&runs, &RunControl::ending, this, &SessionControl::keep);
    connect(&playback, &PlaybackControl::begun, this, [this] { rests_ = true; });
    connect(&runs, &RunControl::begun, this, [this] { rests_ = false; });
    connect(&runs, &RunControl::started, this, [this] { rests_ = false; });
    showBefore();
}

void SessionControl::keepIn(const std::filesystem::path& folder) {
    folder_.emplace(folder);
    if (!folder_->isOurs()) {
        folder_.reset();
        return;
    }
    showBefore();
    writer_ = std::make_unique<LatestWriter<std::string>>(
        [file = folder_->session()](const std::string& text) {
            OutputFile output(file);
            output.stream() << text;
            output.commitToDisk();
        });
    due_.start(kKeepPeriod);
}

void SessionControl::openLast() {
    scenes_.open(folder_->last(), {}, [this](const QString& why) { return setLastAside(why); });
}

QString SessionControl::setLastAside(const QString& reason) {
    const std::filesystem::path aside = folder_->setLastAside();
    showBefore();
    const QString words = tr("The last session could not be opened: %1\n\nIt stays as %2. ")
                              .arg(reason, shownPath(aside));
    return words + (aside == folder_->before()
                        ? tr("File > Restore the session before tries again.")
                        : tr("File > Open tries again."));
}

void SessionControl::showBefore() {
    const bool isThere = folder_ && !folder_->before().empty();
    window_.menus().refuse(*window_.menus().restoreSession,
                           isThere ? QString() : tr("No earlier session is kept"));
}

void SessionControl::save() {
    const auto file = files_.find(edits_.origin());
    if (file == files_.end()) {
        window_.menus().saveSessionAs->trigger();
    } else {
        saveAs(std::filesystem::path(file->second));
    }
}

void SessionControl::saveAs(const std::filesystem::path& file) {
    if (runs_.run() == nullptr) {
        return;
    }
    const std::filesystem::path target =
        file.has_extension() ? file : std::filesystem::path(file.string() + ".toml");
    try {
        saveScene(scene(), target, windowSection(window()));
        files_[edits_.origin()] = std::filesystem::absolute(target);
        saved_ = QFile::decodeName(target.parent_path().c_str());
        window_.tell(tr("Saved as %1").arg(shownPath(target)));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
}

/// Its own file, else one of its name where the last one was saved, or among the user's documents.
void SessionControl::suggestFile() {
    const auto own = files_.find(edits_.origin());
    if (own != files_.end()) {
        window_.setSceneFile(QFile::decodeName(own->second.c_str()));
        return;
    }
    const auto opened = names_.find(edits_.origin());
    std::string name;
    if (opened != names_.end()) {
        name = opened->second;
    } else if (runs_.run() != nullptr) {
        const SampleDescription& sample = runs_.run()->scene().description.sample;
        name = std::filesystem::path(sample.file).stem().string();
    }
    name = (name.empty() ? "session" : name) + ".toml";
    const QString folder = saved_.isEmpty()
                               ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                               : saved_;
    window_.setSceneFile(folder + QLatin1Char('/') + QFile::decodeName(name.c_str()));
}

void SessionControl::begin() {
    opened_ = scene();
    isEdited_ = false;
}

/// What the program kept by itself is no file of the user's: it stays as it is.
void SessionControl::restore(const std::filesystem::path& file, const QVariantMap& kept) {
    const bool isKept = folder_ && folder_->holds(file);
    const int origin = edits_.origin();
    if (!isKept) {
        files_[origin] = std::filesystem::absolute(file);
    } else {
        names_.erase(origin);
        isEdited_ = isEditedIn(kept);
        if (const auto own = pathFromText(kept.value(kFile).toString().toStdString());
            own && !own->empty()) {
            files_[origin] = *own;
        }
    }
    restoreViews(window_, kept);
    restoreLayout(window_, kept);
    restoreStand(window_, kept);
    if (isKept) {
        window_.tell(tr("The last session is here again, as it was"));
    }
}

void SessionControl::keep() {
    if (writer_ == nullptr || runs_.run() == nullptr || rests_ || !runs_.fixedBy().isEmpty()) {
        return;
    }
    std::string now = text();
    if (now != kept_) {
        kept_ = now;
        writer_->write(std::move(now));
    }
    if (const std::string failure = writer_->takeFailure(); !failure.empty()) {
        window_.complain(tr("The session cannot be kept: %1\n\nThis is tried again every few "
                            "seconds, and when the program ends.")
                             .arg(QString::fromUtf8(failure.c_str())));
    }
}

SceneDescription SessionControl::scene() const {
    SceneDescription scene = withoutHashes(runs_.run()->scene().description);
    scene.settings = ofScene(runs_.run()->sensingSettings());
    forEachFile(scene, [](std::string& file) { file = std::filesystem::absolute(file).string(); });
    return scene;
}

QVariantMap SessionControl::window() const {
    QVariantMap kept;
    keepLayout(window_, kept);
    keepViews(window_, kept);
    keepStand(window_, kept);
    keepTipPlace(runs_.run()->basePosition().head<2>(), kept);
    return kept;
}

std::string SessionControl::text() {
    const SceneDescription now = scene();
    isEdited_ = isEdited_ || now != opened_;
    QVariantMap kept = window();
    keepEdited(isEdited_, kept);
    if (const auto own = files_.find(edits_.origin()); own != files_.end()) {
        kept.insert(kFile, QString::fromStdString(pathText(own->second)));
    }
    return sceneText(now) + windowSection(kept);
}

}  // namespace asperity
