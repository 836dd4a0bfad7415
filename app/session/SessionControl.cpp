#include "app/session/SessionControl.h"

#include "app/session/WindowSection.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/SceneSaving.h"
#include "core/scene/SettingFields.h"
#include "ui/window/LayoutMemory.h"
#include "ui/window/MainWindow.h"
#include "ui/window/ViewMemory.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QStandardPaths>

#include <fcntl.h>
#include <system_error>

namespace asperity {

namespace {

constexpr int kKeepPeriod = 250;  // between two looks at what has changed [ms]
constexpr const char* kSession = "session.toml";
constexpr const char* kBefore = "session_before.toml";

}  // namespace

SessionControl::SessionControl(MainWindow& window, RunControl& runs, SceneControl& scenes)
    : window_(window), runs_(runs), scenes_(scenes) {
    WindowMenus& menus = window.menus();
    connect(menus.saveSession, &QAction::triggered, this, &SessionControl::save);
    connect(&window, &MainWindow::sceneFileChosen, this,
            [this](const QString& file) { saveAs(std::filesystem::path(file.toStdString())); });
    connect(menus.restoreSession, &QAction::triggered, this, [this] { scenes_.open(before()); });
    connect(&scenes, &SceneControl::sceneTaken, this, [this] { file_.clear(); });
    connect(&scenes, &SceneControl::sessionOpened, this, &SessionControl::restore);
    connect(&due_, &QTimer::timeout, this, &SessionControl::keep);
    connect(&runs, &RunControl::ending, this, &SessionControl::keep);
    showBefore();
}

void SessionControl::keepIn(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    lock_ = FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!lock_.isOpen() || !lock_.lock()) {
        return;
    }
    folder_ = folder;
    if (std::filesystem::exists(folder / kSession, failure)) {
        std::filesystem::rename(folder / kSession, folder / kBefore, failure);
    }
    showBefore();
    writer_ = std::make_unique<LatestFile>(folder / kSession);
    due_.start(kKeepPeriod);
}

std::filesystem::path SessionControl::before() const {
    std::error_code unknown;
    const std::filesystem::path file = folder_ / kBefore;
    return !folder_.empty() && std::filesystem::exists(file, unknown) ? file
                                                                      : std::filesystem::path();
}

void SessionControl::showBefore() {
    window_.menus().refuse(*window_.menus().restoreSession,
                           before().empty() ? tr("No earlier session is kept") : QString());
}

void SessionControl::save() {
    if (file_.empty()) {
        window_.menus().saveSessionAs->trigger();
    } else {
        saveAs(file_);
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
        file_ = target;
        window_.setSceneFile(QString::fromStdString(target.string()));
        window_.tell(tr("Saved as %1").arg(QString::fromStdString(printable(target.string()))));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
}

/// The one before is no file of the user's: it stays as it is.
void SessionControl::restore(const std::filesystem::path& file, const QVariantMap& kept) {
    if (folder_.empty() || file.parent_path() != folder_) {
        file_ = file;
    }
    restoreViews(window_, kept);
    restoreLayout(window_, kept);
    restoreStand(window_, kept);
    if (file_ != file) {
        window_.tell(tr("The last session is here again, as it was"));
    }
}

void SessionControl::keep() {
    if (writer_ == nullptr || runs_.run() == nullptr) {
        return;
    }
    std::string now = text();
    if (now != kept_) {
        kept_ = now;
        writer_->write(std::move(now));
    }
    if (const std::string failure = writer_->takeFailure(); !failure.empty()) {
        due_.stop();
        window_.complain(tr("The session is not kept: %1").arg(QString::fromUtf8(failure.c_str())));
    }
}

SceneDescription SessionControl::scene() const {
    SceneDescription scene = runs_.run()->scene().description;
    scene.settings = ofScene(runs_.run()->sensingSettings());
    if (!scene.sample.shape) {
        scene.sample.file = std::filesystem::absolute(scene.sample.file).string();
    }
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

std::string SessionControl::text() const { return sceneText(scene()) + windowSection(window()); }

std::filesystem::path sessionFolder() {
    const QString place = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(place.toStdString()) / "session";
}

}  // namespace asperity
