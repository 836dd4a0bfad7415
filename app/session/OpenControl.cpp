#include "app/session/OpenControl.h"

#include "app/program/DataFolder.h"
#include "app/session/ShownPreview.h"
#include "core/PathText.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "ui/ShownPath.h"
#include "ui/window/Dialogs.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PreviewPane.h"
#include "ui/window/RecentMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDir>
#include <QFile>

#include <system_error>

namespace asperity {

namespace {

constexpr int kLookDelay = 120;  // that choices rest before they are looked at [ms]

std::vector<ScanFileType> scanFiles() {
    std::vector<ScanFileType> types;
    for (const ReadableFormat& format : readableFormats()) {
        ScanFileType& type = types.emplace_back();
        type.name = QString::fromStdString(format.name);
        for (const std::string& extension : format.extensions) {
            type.patterns << QStringLiteral("*") + QString::fromStdString(extension);
        }
    }
    return types;
}

std::vector<RecentFile> shownFiles(const RecentFiles& recent) {
    std::vector<RecentFile> shown;
    for (const std::filesystem::path& file : recent.files()) {
        std::error_code unknown;
        shown.push_back({.path = QFile::decodeName(file.string().c_str()),
                         .name = shownPath(file.filename()),
                         .isThere = std::filesystem::is_regular_file(file, unknown)});
    }
    return shown;
}

}  // namespace

OpenControl::OpenControl(MainWindow& window, SceneControl& scenes)
    : window_(window)
    , scenes_(scenes)
    , work_({.begin =
                 [this](const QString&) {
                     if (dialog_ != nullptr) {
                         dialog_->setProgress(0.0);
                     }
                 },
             .setFraction =
                 [this](double share) {
                     if (dialog_ != nullptr) {
                         dialog_->setProgress(share);
                     }
                 },
             .end =
                 [this] {
                     if (dialog_ != nullptr) {
                         dialog_->setProgress(std::nullopt);
                     }
                 }},
            {.finished = [this](Looked& looked) { show(looked); },
             .failed =
                 [this](const std::exception_ptr& reason) {
                     if (dialog_ != nullptr) {
                         dialog_->showFailure(reasonOf(reason));
                     }
                 }}) {
    soon_.setSingleShot(true);
    soon_.setInterval(kLookDelay);
    connect(&soon_, &QTimer::timeout, this, &OpenControl::look);
    connect(window.menus().open, &QAction::triggered, this, &OpenControl::ask);
    RecentMenu& menu = *window.menus().recent;
    connect(&menu, &RecentMenu::aboutToShow, this, &OpenControl::showRecent);
    connect(&menu, &RecentMenu::chosen, this, &OpenControl::openRecent);
    connect(&menu, &RecentMenu::clearRequested, &recent_, &RecentFiles::clear);
    connect(&recent_, &RecentFiles::changed, this, &OpenControl::showRecent);
    connect(&scenes, &SceneControl::opened, &recent_, &RecentFiles::add);
    showRecent();
}

void OpenControl::showRecent() { window_.menus().recent->setFiles(shownFiles(recent_)); }

void OpenControl::openRecent(int index) {
    scenes_.open(recent_.files().at(static_cast<std::size_t>(index)));
}

void OpenControl::ask() {
    if (dialog_ != nullptr) {
        dialog_->raise();
        return;
    }
    dialog_ = new OpenDialog(scanFilters(scanFiles()), &window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->setRecent(shownFiles(recent_));
    const QString samples = QFile::decodeName((dataFolder() / "samples").c_str());
    dialog_->setFolder(recent_.folder().isEmpty() ? samples : recent_.folder());
    dialog_->setPlaces({QDir::homePath(), QDir::rootPath(), samples});
    connect(dialog_, &OpenDialog::selected, this, [this](const QString& file) {
        work_.cancel();
        file_ = file;
        shownGap_.reset();
        if (!file.isEmpty()) {
            look();
        }
    });
    connect(dialog_, &OpenDialog::choicesChanged, &soon_, qOverload<>(&QTimer::start));
    connect(dialog_, &OpenDialog::opened, this, &OpenControl::open);
    connect(dialog_, &QDialog::finished, this, [this] {
        soon_.stop();
        work_.cancel();
        recent_.setFolder(dialog_->folder());
        previewer_ = std::make_shared<ScanPreviewer>();  // what it read need not stay
    });
    dialog_->open();
}

SceneOverrides OpenControl::overrides() const {
    const OpenChoices& choices = dialog_->preview().choices();
    return {.channel = choices.channel.toStdString(),
            .leveling = choices.leveling,
            .levelPoints = choices.levelPoints,
            .smoothingPixels = std::nullopt,
            .setpoint = std::nullopt,
            .scale = choices.scale,
            .crop = choices.crop};
}

void OpenControl::look() {
    if (dialog_ == nullptr || file_.isEmpty()) {
        return;
    }
    work_.start({}, [previewer = previewer_, input = pathOf(file_),
                     overrides = overrides()](Progress& progress) {
        ScanPreview preview = previewer->preview(input, overrides, &progress);
        OpenPreview shown = shownPreview(preview);
        return Looked{.preview = std::move(preview), .shown = std::move(shown)};
    });
}

void OpenControl::show(Looked& looked) {
    if (dialog_ == nullptr) {
        return;
    }
    const auto& gap = looked.preview.gap;
    const bool isNew = gap && gap != shownGap_;
    shownGap_ = gap;
    dialog_->showPreview(looked.shown);
    if (isNew) {
        if (const auto known = scenes_.scales().suggestion(pathOf(file_), *gap)) {
            dialog_->preview().suggest(*known);
        }
    }
}

void OpenControl::open(const QString& file) {
    const SceneOverrides chosen = overrides();
    if (shownGap_) {
        scenes_.scales().learn(pathOf(file), *shownGap_, chosen.scale);
    }
    scenes_.open(pathOf(file), chosen);
}

}  // namespace asperity
