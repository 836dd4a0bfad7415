#include "app/window/session/SessionControl.h"

#include "app/runs/RunFolder.h"
#include "app/window/WindowSection.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/SettingFields.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QFile>
#include <QStandardPaths>

#include <fcntl.h>
#include <string>
#include <system_error>

namespace asperity {

namespace {

constexpr const char* kSession = "session.toml";
constexpr const char* kBefore = "session_before.toml";
constexpr const char* kLast = "session_last.toml";
const QString kEdited = QStringLiteral("session/edited");

/// Names for sessions that cannot be opened, from 1.
std::filesystem::path unopened(const std::filesystem::path& folder, int number) {
    const std::string end = number == 1 ? ".toml" : "_" + std::to_string(number) + ".toml";
    return folder / ("session_unopened" + end);
}

int firstFree(const std::filesystem::path& folder) {
    int number = 1;
    while (isThere(unopened(folder, number))) {
        ++number;
    }
    return number;
}

constexpr int kKeepPeriod = 250;  // between two looks at what has changed [ms]
const QString kFile = QStringLiteral("session/file");

}  // namespace

SessionFolder::SessionFolder(const std::filesystem::path& folder) : folder_(folder), lock_(-1) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    lock_ = FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    isOurs_ = lock_.isOpen() && lock_.lock();
    if (isOurs_) {
        passOn();
    }
}

void SessionFolder::passOn() {
    std::error_code failure;
    if (isThere(session())) {
        if (isEditedIn(windowSectionOf(session()))) {
            std::filesystem::rename(session(), folder_ / kBefore, failure);
            std::filesystem::remove(folder_ / kLast, failure);
        } else {
            std::filesystem::rename(session(), folder_ / kLast, failure);
        }
    }
    for (const char* const name : {kLast, kBefore}) {
        if (last_.empty() && isThere(folder_ / name)) {
            last_ = folder_ / name;
        }
    }
}

std::filesystem::path SessionFolder::session() const { return folder_ / kSession; }

std::filesystem::path SessionFolder::before() const {
    if (!isOurs_) {
        return {};
    }
    if (isThere(folder_ / kBefore)) {
        return folder_ / kBefore;
    }
    const int next = firstFree(folder_);
    return next > 1 ? unopened(folder_, next - 1) : last_;
}

bool SessionFolder::holds(const std::filesystem::path& file) const {
    return file.parent_path() == folder_;
}

std::filesystem::path SessionFolder::setLastAside() {
    const std::filesystem::path aside = unopened(folder_, firstFree(folder_));
    std::error_code failure;
    std::filesystem::rename(last_, aside, failure);
    std::filesystem::path where = failure ? last_ : aside;
    last_.clear();
    return where;
}

void keepEdited(bool isEdited, QVariantMap& kept) { kept.insert(kEdited, isEdited); }

/// Sessions of programs that noted nothing may have been edited.
bool isEditedIn(const QVariantMap& kept) {
    return !kept.isEmpty() && kept.value(kEdited, true).toBool();
}

std::filesystem::path sessionFolder() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return std::filesystem::path(folder.toStdString()) / "session";
}

SessionControl::SessionControl(Stage& stage) : Feature(stage), scenes_(stage.scenes()) {
    addEntries();
    connect(&scenes_, &SceneOpener::sceneTaken, this, &SessionControl::begin);
    connect(&scenes_, &SceneOpener::opened, this, [this](const std::filesystem::path& file) {
        names_[edits_.origin()] = file.stem().string();
    });
    connect(&scenes_, &SceneOpener::sessionOpened, this, &SessionControl::restore);
    connect(&due_, &QTimer::timeout, this, &SessionControl::keep);
    connect(&runs_, &RunControl::ending, this, &SessionControl::keep);
}

void SessionControl::addEntries() {
    Menus& menus = host_.menus();
    const auto changes = [this] { return runs_.moveRefusal(); };
    const QAction& save = menus.add(
        {MenuName::File, 0, 60}, "saveSession",
        {.text = tr("&Save session"),
         .tip = tr("Write scene, views and panels as they are now to the file of the session"),
         .shortcuts = {QKeySequence::Save},
         .refusal = changes});
    saveAs_ = &menus.add({MenuName::File, 0, 70}, "saveSessionAs",
                         {.text = tr("Sa&ve session as…"),
                          .tip = tr("Write scene, views and panels as they are now to a file "
                                    "(.toml), which opens as they are"),
                          .shortcuts = {tr("Ctrl+Shift+S")},
                          .refusal = changes});
    const QAction& restore =
        menus.add({MenuName::File, 0, 80}, "restoreSession",
                  {.text = tr("Restore the session &before"),
                   .tip = tr("Open the session before this one as it was at its end"),
                   .refusal = [this] {
                       const bool isThere = folder_ && !folder_->before().empty();
                       return isThere ? QString() : tr("No earlier session is kept");
                   }});
    startWithLast_ = &menus.add({MenuName::File, 0, 90}, "startWithSession",
                                {.text = tr("Start &with the last session"),
                                 .tip = tr("Without a file, the program opens the last session"),
                                 .isCheckable = true,
                                 .keptAs = QStringLiteral("session/startWithLast")});
    startWithLast_->setChecked(true);
    connect(&save, &QAction::triggered, this, &SessionControl::save);
    connect(saveAs_, &QAction::triggered, this, [this] {
        const QString file = askWhereToSave(&host_.widget(), {.kind = FileKind::Session,
                                                              .title = tr("Save the session"),
                                                              .suggestion = suggestedFile(),
                                                              .filters = tr("Sessions (*.toml)")});
        if (!file.isEmpty()) {
            saveAs(pathOf(file));
        }
    });
    connect(&restore, &QAction::triggered, this, [this] { scenes_.open(folder_->before()); });
}

bool SessionControl::startsWithLast() const {
    return folder_ && !folder_->last().empty() && startWithLast_->isChecked();
}

void SessionControl::keepIn(const std::filesystem::path& folder) {
    folder_.emplace(folder);
    if (!folder_->isOurs()) {
        folder_.reset();
        return;
    }
    host_.menus().refresh();
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
    host_.menus().refresh();
    const QString words = tr("The last session could not be opened: %1\n\nIt stays as %2. ")
                              .arg(reason, shownPath(aside));
    return words + (aside == folder_->before()
                        ? tr("File > Restore the session before tries again.")
                        : tr("File > Open scan or scene… tries again."));
}

void SessionControl::save() {
    const auto file = files_.find(edits_.origin());
    if (file == files_.end()) {
        saveAs_->trigger();
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
        rememberFolderOf(FileKind::Session, QFile::decodeName(target.c_str()));
        host_.tell(tr("Saved as %1").arg(shownPath(target)));
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
    }
}

/// Its own file, else one of its name where the last one was saved, or among the user's documents.
QString SessionControl::suggestedFile() const {
    const auto own = files_.find(edits_.origin());
    if (own != files_.end()) {
        return QFile::decodeName(own->second.c_str());
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
    const QString last = lastFolder(FileKind::Session);
    const QString folder =
        last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : last;
    return folder + QLatin1Char('/') + QFile::decodeName(name.c_str());
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
    for (const SessionPart& part : stage_.sessionParts()) {
        if (part.restore) {
            part.restore(kept);
        }
    }
    if (isKept) {
        host_.tell(tr("The last session is here again, as it was"));
    }
}

void SessionControl::keep() {
    if (writer_ == nullptr || runs_.run() == nullptr || !runs_.editRefusal().isEmpty()) {
        return;
    }
    std::string now = text();
    if (now != kept_) {
        kept_ = now;
        writer_->write(std::move(now));
    }
    if (const std::string failure = writer_->takeFailure(); !failure.empty()) {
        host_.complain(tr("The session cannot be kept: %1\n\nThis is tried again every few "
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
    for (const SessionPart& part : stage_.sessionParts()) {
        part.keep(kept);
    }
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
