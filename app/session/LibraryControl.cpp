#include "app/session/LibraryControl.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneFieldChange.h"
#include "ui/ShownPath.h"
#include "ui/panels/LibraryBar.h"
#include "ui/window/Dialogs.h"
#include "ui/window/MainWindow.h"

#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

/// Where the platform keeps what a user makes with a program; empty: nowhere.
std::filesystem::path ownFolder(const std::string& kind) {
    const QString place = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return place.isEmpty() ? std::filesystem::path()
                           : std::filesystem::path(place.toStdString()) / kind;
}

QString withoutEdited(QString name) {
    const QString suffix = QString::fromUtf8(kEditedSuffix);
    return name.endsWith(suffix) ? name.chopped(suffix.size()) : name;
}

}  // namespace

LibraryControl::LibraryControl(MainWindow& window, RunControl& runs, SceneEdits& edits,
                               LibraryBar& bar, LibraryKind kind)
    : window_(window)
    , runs_(runs)
    , edits_(edits)
    , bar_(bar)
    , kind_(std::move(kind))
    , library_(kind_.folder) {
    library_.setFolder(ownFolder(kind_.folder));
    connect(&bar, &LibraryBar::chosen, this, &LibraryControl::choose);
    connect(&bar, &LibraryBar::saveRequested, this, &LibraryControl::save);
    connect(&bar, &LibraryBar::renameRequested, this, &LibraryControl::rename);
    connect(&bar, &LibraryBar::deleteRequested, this, &LibraryControl::removePresent);
    connect(&runs, &RunControl::begun, this, &LibraryControl::show);
    connect(&edits, &SceneEdits::changed, this, &LibraryControl::show);
}

void LibraryControl::setFolder(const std::filesystem::path& folder) {
    library_.setFolder(folder);
    readAll();
}

void LibraryControl::readAll() {
    items_.clear();
    for (const UserLibrary::Entry& entry : library_.entries()) {
        add(entry);
    }
    show();
}

void LibraryControl::add(const UserLibrary::Entry& entry) {
    try {
        const SceneDescription scene = kind_.read(entry.file);
        checkScene(scene);
        const QString name = kind_.nameOf(scene, entry.file);
        items_.push_back(
            {.entry = entry,
             .scene = scene,
             .name = entry.own ? tr("%1 (own)").arg(name) : name,
             .notes = QString::fromStdString(printable(asperity::notesOf(entry.file)))});
    } catch (const Error& error) {
        window_.tell(QString::fromUtf8(error.what()));
    }
}

void LibraryControl::choose(int index) {
    if (const SceneDescription* const now = edits_.wanted()) {
        const Item& item = items_.at(static_cast<std::size_t>(index));
        edits_.change(QStringLiteral("%1: %2").arg(kind_.noun, item.name),
                      kind_.with(*now, item.scene));
    }
}

std::optional<std::size_t> LibraryControl::present() const {
    const SceneDescription* const scene = edits_.wanted();
    const auto found =
        scene == nullptr ? items_.end() : std::ranges::find_if(items_, [&](const Item& item) {
            return kind_.isSame(item.scene, *scene);
        });
    return found == items_.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - items_.begin()));
}

void LibraryControl::listUnsaved(const SceneDescription& scene) {
    const QString name = kind_.nameOf(scene, {});
    std::erase_if(items_,
                  [&](const Item& item) { return item.entry.file.empty() && item.name == name; });
    items_.push_back({.entry = {}, .scene = scene, .name = name, .notes = {}});
}

void LibraryControl::show() {
    const SceneDescription* const scene = edits_.wanted();
    if (scene == nullptr) {
        return;
    }
    if (!present()) {
        listUnsaved(*scene);
    }
    QStringList names;
    QStringList notes;
    for (const Item& item : items_) {
        names << item.name;
        notes << item.notes;
    }
    const std::size_t index = *present();
    bar_.setEntries(names, notes);
    bar_.setCurrent(static_cast<int>(index));
    bar_.setOwn(items_[index].entry.own);
    Q_EMIT listed(names, static_cast<int>(index));
}

/// Those of the file that the scene has it from, as far as the name tells.
std::string LibraryControl::notesOf(const SceneDescription& scene) const {
    const QString name = withoutEdited(kind_.nameOf(scene, {}));
    const auto origin = std::ranges::find_if(items_, [&](const Item& item) {
        return kind_.isSame(item.scene, scene) || item.name == name;
    });
    if (origin == items_.end() || origin->notes.isEmpty()) {
        return {};
    }
    const std::string notes = origin->notes.toStdString();
    return kind_.isSame(origin->scene, scene)
               ? notes
               : "Changed from " + origin->name.toStdString() + ": " + notes;
}

bool LibraryControl::saveAs(const QString& name) {
    const SceneDescription* const now = edits_.wanted();
    if (now == nullptr) {
        return false;
    }
    const SceneDescription saved = kind_.renamed(*now, name.toStdString());
    try {
        library_.save(name.toStdString(), kind_.textOf(saved, notesOf(*now)));
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        return false;
    }
    edits_.change(QStringLiteral("%1: %2").arg(kind_.noun, name), kind_.with(*now, saved));
    readAll();
    return true;
}

void LibraryControl::withName(const QString& name, const std::filesystem::path& own,
                              const std::function<void()>& act) {
    const std::filesystem::path replaced = library_.replacedBy(name.toStdString());
    if (replaced.empty() || replaced == own) {
        act();
        return;
    }
    const auto item = std::ranges::find_if(
        items_, [&](const Item& listed) { return listed.entry.file == replaced; });
    askWhether(&window_,
               tr("“%1” is in the same file, %2. Replace it?")
                   .arg(item == items_.end() ? name : item->name, shownPath(replaced.filename())),
               tr("Replace"), act);
}

void LibraryControl::save() {
    if (const SceneDescription* const now = edits_.wanted()) {
        askForName(&window_, tr("%1 of your own").arg(kind_.noun),
                   tr("Name, as lists are to show it:"), withoutEdited(kind_.nameOf(*now, {})),
                   [this](const QString& name) {
                       withName(name, {}, [this, name] {
                           if (saveAs(name)) {
                               window_.tell(tr("Saved: %1").arg(name));
                           }
                       });
                   });
    }
}

void LibraryControl::rename() {
    const std::optional<std::size_t> index = present();
    if (!index || !items_[*index].entry.own) {
        return;
    }
    const Item item = items_[*index];
    askForName(&window_, tr("Rename"), tr("Another name:"),
               kind_.nameOf(item.scene, item.entry.file), [this, item](const QString& name) {
                   withName(name, item.entry.file, [this, item, name] {
                       const bool isOther =
                           fileNameFor(name.toStdString()) != item.entry.file.stem();
                       if (saveAs(name) && isOther) {
                           remove(item.entry);
                       }
                   });
               });
}

void LibraryControl::removePresent() {
    if (const std::optional<std::size_t> index = present()) {
        const Item item = items_[*index];
        askWhether(&window_,
                   tr("Delete “%1” from your library? This cannot be undone.").arg(item.name),
                   tr("Delete"), [this, item] { remove(item.entry); });
    }
}

void LibraryControl::remove(const UserLibrary::Entry& entry) {
    try {
        library_.remove(entry);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    readAll();
}

}  // namespace asperity
