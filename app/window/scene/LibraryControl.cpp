#include "app/window/scene/LibraryControl.h"

#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/scene/ScenePanel.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/scene/ProbeFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/io/scene/TomlFile.h"
#include "core/scene/SceneFieldChange.h"
#include "ui/shell/Dialogs.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"

#include <QGridLayout>
#include <QStandardPaths>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

/// Where the platform keeps what a user makes with a program; empty: nowhere.
std::filesystem::path ownFolder(const std::string& kind) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    return folder.isEmpty() ? std::filesystem::path()
                            : std::filesystem::path(folder.toStdString()) / kind;
}

QString withoutEdited(QString name) {
    const QString suffix = QString::fromUtf8(kEditedSuffix);
    return name.endsWith(suffix) ? name.chopped(suffix.size()) : name;
}

constexpr int kLibraryGap = 3;  ///< [px]

LibraryKind materialKind() {
    using Scene = SceneDescription;
    return {
        .folder = "materials",
        .noun = LibraryControl::tr("Material"),
        .read =
            [](const auto& file) { return withMaterial(defaultScene(), readMaterialFile(file)); },
        .nameOf =
            [](const Scene& scene, const auto& /*file*/) {
                return QString::fromStdString(scene.sample.material.name).replace('_', ' ');
            },
        .isSame = [](const Scene& a,
                     const Scene& b) { return a.sample.material == b.sample.material; },
        .with = [](const Scene& scene,
                   const Scene& item) { return withMaterial(scene, item.sample.material); },
        .renamed =
            [](const Scene& scene, const std::string& name) {
                SampleMaterial material = scene.sample.material;
                material.name = name;
                return withMaterial(scene, material);
            },
        .textOf =
            [](const Scene& scene, const std::string& notes) {
                return materialText(scene.sample.material, notes);
            }};
}

SceneDescription withProbe(SceneDescription scene, const ProbeDescription& probe) {
    const SceneDescription before = scene;
    scene.probe = probe.lever;
    scene.detector = probe.detector;
    scene.probeSource = probe.source;
    carryTruth(before, scene);
    return scene;
}

/// A probe says no name.
LibraryKind probeKind() {
    using Scene = SceneDescription;
    return {.folder = "probes",
            .noun = LibraryControl::tr("Probe"),
            .read = [](const auto& file) { return withProbe(defaultScene(), readProbe(file)); },
            .nameOf =
                [](const Scene& /*scene*/, const auto& file) {
                    return file.empty()
                               ? LibraryControl::tr("of this scene")
                               : QString::fromStdString(file.stem().string()).replace('_', ' ');
                },
            .isSame = [](const Scene& a,
                         const Scene& b) { return a.probe == b.probe && a.detector == b.detector; },
            .with =
                [](const Scene& scene, const Scene& item) {
                    return withProbe(scene, {item.probe, item.detector});
                },
            .renamed = [](const Scene& scene, const std::string& /*name*/) { return scene; },
            .textOf =
                [](const Scene& scene, const std::string& notes) {
                    return probeText({scene.probe, scene.detector}, notes);
                }};
}

}  // namespace

LibraryControl::LibraryControl(Stage& stage, LibraryBar& bar, LibraryKind kind)
    : Feature(stage), bar_(bar), kind_(std::move(kind)), library_(kind_.folder) {
    library_.setFolder(ownFolder(kind_.folder));
    connect(&bar, &LibraryBar::chosen, this, &LibraryControl::choose);
    connect(&bar, &LibraryBar::saveRequested, this, &LibraryControl::save);
    connect(&bar, &LibraryBar::renameRequested, this, &LibraryControl::rename);
    connect(&bar, &LibraryBar::deleteRequested, this, &LibraryControl::removePresent);
    connect(&runs_, &RunControl::begun, this, &LibraryControl::show);
    connect(&edits_, &SceneEdits::changed, this, &LibraryControl::show);
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
        host_.tell(QString::fromUtf8(error.what()));
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
        host_.complain(QString::fromUtf8(error.what()));
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
    askWhether(&host_.widget(),
               tr("“%1” is in the same file, %2. Replace it?")
                   .arg(item == items_.end() ? name : item->name, shownPath(replaced.filename())),
               tr("Replace"), act);
}

void LibraryControl::save() {
    if (const SceneDescription* const now = edits_.wanted()) {
        askForName(&host_.widget(), tr("%1 of your own").arg(kind_.noun),
                   tr("Name, as lists are to show it:"), withoutEdited(kind_.nameOf(*now, {})),
                   [this](const QString& name) {
                       withName(name, {}, [this, name] {
                           if (saveAs(name)) {
                               host_.tell(tr("Saved: %1").arg(name));
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
    askForName(&host_.widget(), tr("Rename"), tr("Another name:"),
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
        askWhether(&host_.widget(),
                   tr("Delete “%1” from your library? This cannot be undone.").arg(item.name),
                   tr("Delete"), [this, item] { remove(item.entry); });
    }
}

void LibraryControl::remove(const UserLibrary::Entry& entry) {
    try {
        library_.remove(entry);
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
    }
    readAll();
}

LibraryBar::LibraryBar(const QString& kind, QWidget* parent)
    : QWidget(parent)
    , kind_(kind)
    , list_(new ChoiceBox(this))
    , save_(newButton(QStringLiteral("save"), tr("Save as…")))
    , rename_(newButton(QStringLiteral("rename"), tr("Rename…")))
    , delete_(newButton(QStringLiteral("delete"), tr("Delete"))) {
    list_->setObjectName(kind + QStringLiteral("Library"));
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    guardFromWheel(*list_);
    auto* rows = new QGridLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kLibraryGap);
    rows->addWidget(list_, 0, 0, 1, 3);
    rows->addWidget(save_, 1, 0);
    rows->addWidget(rename_, 1, 1);
    rows->addWidget(delete_, 1, 2);
    connect(list_, qOverload<int>(&QComboBox::activated), this, &LibraryBar::chosen);
    connect(save_, &QToolButton::clicked, this, &LibraryBar::saveRequested);
    connect(rename_, &QToolButton::clicked, this, &LibraryBar::renameRequested);
    connect(delete_, &QToolButton::clicked, this, &LibraryBar::deleteRequested);
    save_->setToolTip(tr("Save the %1 of this scene under its own name").arg(kind));
    list_->setToolTip(tr("The %1s that come with the program, and your own").arg(kind));
    setOwn(false);
}

QToolButton* LibraryBar::newButton(const QString& name, const QString& text) {
    auto* button = new QToolButton(this);
    button->setObjectName(name + kind_.left(1).toUpper() + kind_.mid(1));
    button->setText(text);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

void LibraryBar::setEntries(const QStringList& names, const QStringList& notes) {
    list_->setNames(names);
    for (int i = 0; i < names.size() && i < notes.size(); ++i) {
        if (!notes.at(i).isEmpty()) {
            list_->setItemData(i, notes.at(i), Qt::ToolTipRole);
        }
    }
}

void LibraryBar::setCurrent(int index) { list_->setCurrentIndex(index); }

void LibraryBar::setOwn(bool own) {
    const QString reason =
        tr("Only your own %1, if listed here, can be renamed or deleted").arg(kind_);
    rename_->setEnabled(own);
    delete_->setEnabled(own);
    rename_->setToolTip(own ? tr("Give your %1 another name").arg(kind_) : reason);
    delete_->setToolTip(own ? tr("Delete the file of your %1; the scene stays as it is").arg(kind_)
                            : reason);
}

MaterialControl::MaterialControl(Stage& stage)
    : LibraryControl(stage, stage.get<ScenePanelControl>().panel().materials(), materialKind()) {
    ControlBar& controls = live_.controls();
    connect(&controls, &ControlBar::materialChosen, this, &MaterialControl::choose);
    connect(this, &MaterialControl::listed, &controls,
            [&controls](const QStringList& names, int present) {
                controls.setMaterials(names);
                controls.setMaterial(present);
            });
    readAll();
}

ProbeControl::ProbeControl(Stage& stage)
    : LibraryControl(stage, stage.get<ScenePanelControl>().panel().probes(), probeKind()) {
    readAll();
}

}  // namespace asperity
