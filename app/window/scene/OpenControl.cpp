#include "app/window/scene/OpenControl.h"

#include "app/program/DataFolder.h"
#include "app/window/scene/PreviewPane.h"
#include "app/window/scene/RecentFiles.h"
#include "core/PrintableText.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/view/ReliefImage.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QDir>
#include <QFile>

#include <cmath>
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

QString text(const std::string& words) { return QString::fromStdString(printable(words)); }

/// Without a unit a prefix would be read as one.
QString quantity(double value, const std::string& unit) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const PhysicalUnit known = parseUnit(unit);  // "mV" must not become "mmV"
    return known.base.empty() ? QString::number(value, 'g', 3)
                              : siText(value * known.factor, known.base.c_str());
}

QString product(const QString& x, const QString& y) { return QStringLiteral("%1 × %2").arg(x, y); }

/// What is told of thinned heights is told so.
QString thinned(const QString& number, int step) {
    return step == 1 ? number : QObject::tr("%1 (of every %2th pixel)").arg(number).arg(step);
}

QString sizeText(const ScanPreview& preview) {
    return preview.sizeX > 0.0 ? product(quantity(preview.sizeX, "m"), quantity(preview.sizeY, "m"))
                               : QObject::tr("not known");
}

QString pitchText(const ScanPreview& preview) {
    return preview.sizeX > 0.0 ? product(quantity(preview.sizeX / preview.columns, "m"),
                                         quantity(preview.sizeY / preview.rows, "m"))
                               : QObject::tr("not known");
}

QString rangeText(const ScanPreview& preview) {
    const HeightStatistics& of = preview.whole.statistics;
    return thinned(QObject::tr("%1 to %2")
                       .arg(quantity(of.lowest, preview.unit), quantity(of.highest, preview.unit)),
                   preview.step);
}

QString rmsText(const ScanPreview& preview) {
    if (preview.leveled.map.heights.empty()) {
        return quantity(preview.whole.statistics.rms, preview.unit);
    }
    const PreviewedHeights& before =
        preview.part.map.heights.empty() ? preview.whole : preview.part;
    return QObject::tr("%1 before leveling, %2 after")
        .arg(quantity(before.statistics.rms, preview.unit),
             quantity(preview.leveled.statistics.rms, preview.unit));
}

QString missingText(const ScanPreview& preview) {
    const std::size_t missing = preview.whole.statistics.invalidPixels;
    if (missing == 0) {
        return QObject::tr("none");
    }
    const double share = 100.0 * static_cast<double>(missing) /
                         static_cast<double>(preview.whole.map.heights.size());
    const QString percent = QObject::tr("%1 %").arg(share, 0, 'g', 2);
    return preview.step == 1 ? QObject::tr("%1 (%2)").arg(missing).arg(percent) : percent;
}

std::vector<OpenFact> factsOf(const ScanPreview& preview) {
    return {{"previewFormat", QObject::tr("Format"), text(preview.format),
             QObject::tr("File type, detected from its content")},
            {"previewPixels", QObject::tr("Pixels"),
             product(QString::number(preview.columns), QString::number(preview.rows)),
             QObject::tr("Columns and rows of the scan")},
            {"previewSize", QObject::tr("Size"), sizeText(preview),
             QObject::tr("Width and height of the whole scan")},
            {"previewPitch", QObject::tr("Pixel"), pitchText(preview),
             QObject::tr("Width and height of a pixel")},
            {"previewRange", QObject::tr("Heights"), rangeText(preview),
             QObject::tr("Lowest and highest value of the channel, as in the file")},
            {"previewRms", QObject::tr("Rms"), rmsText(preview),
             QObject::tr("Root mean square of the heights about their mean, in the part to load")},
            {"previewMissing", QObject::tr("No data"), missingText(preview),
             QObject::tr("Pixels of the scan without data; heights there are filled in")}};
}

std::vector<OpenChannel> channelsOf(const ScanPreview& preview) {
    std::vector<OpenChannel> channels;
    for (const PreviewedChannel& channel : preview.channels) {
        channels.push_back({.name = QString::fromStdString(channel.name),
                            .unit = text(channel.unit.empty() ? "–" : channel.unit),
                            .direction = text(channel.direction),
                            .pixels = {channel.columns, channel.rows},
                            .opens = channel.opens});
    }
    return channels;
}

QStringList notesOf(const ScanPreview& preview) {
    QStringList notes;
    for (const std::string& note : preview.notes) {
        notes << text(note);
    }
    for (const Provenance& entry : preview.provenance) {
        notes << QStringLiteral("%1: %2 (%3)")
                     .arg(text(entry.what), text(entry.value), text(entry.source));
    }
    return notes;
}

}  // namespace

OpenControl::OpenControl(Stage& stage)
    : Feature(stage)
    , scenes_(stage.get<SceneControl>())
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
    const QAction& entry =
        host_.menus().add({MenuName::File, 0, 10}, "open",
                          {.text = tr("&Open scan or scene…"),
                           .tip = tr("Open a height-map file or a scene"),
                           .shortcuts = {QKeySequence::Open},
                           .refusal = [this] { return scenes_.runs().fixedBy(); }});
    connect(&entry, &QAction::triggered, this, &OpenControl::ask);
    menu_ = new RecentMenu(
        host_.menus().addMenu({MenuName::File, 0, 20}, "recent", tr("Open r&ecent")));
    connect(menu_, &RecentMenu::aboutToShow, this, &OpenControl::showRecent);
    connect(menu_, &RecentMenu::chosen, this, &OpenControl::openRecent);
    connect(menu_, &RecentMenu::clearRequested, &recent_, &RecentFiles::clear);
    connect(&recent_, &RecentFiles::changed, this, &OpenControl::showRecent);
    connect(&scenes_, &SceneControl::opened, &recent_, &RecentFiles::add);
    showRecent();
}

void OpenControl::showRecent() { menu_->setFiles(shownFiles(recent_)); }

void OpenControl::openRecent(int index) {
    scenes_.open(recent_.files().at(static_cast<std::size_t>(index)));
}

void OpenControl::ask() {
    if (dialog_ != nullptr) {
        dialog_->raise();
        return;
    }
    dialog_ = new OpenDialog(scanFilters(scanFiles()), &host_.widget());
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    dialog_->setRecent(shownFiles(recent_));
    const QString samples = QFile::decodeName((dataFolder() / "samples").c_str());
    dialog_->setFolder(recent_.folder().isEmpty() ? samples : recent_.folder());
    dialog_->setFolders({QDir::homePath(), QDir::rootPath(), samples});
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

OpenPreview shownPreview(const ScanPreview& preview) {
    OpenPreview shown{.format = text(preview.format),
                      .channels = channelsOf(preview),
                      .channel = QString::fromStdString(preview.channel),
                      .pixels = {preview.columns, preview.rows},
                      .size = {preview.sizeX, preview.sizeY},
                      .gap = preview.gap,
                      .isMap = !preview.channels.empty(),
                      .leveling = preview.leveling,
                      .levelPoints = preview.levelPoints,
                      .crop = preview.crop,
                      .before = heightPicture(preview.whole.map),
                      .after = {},
                      .facts = factsOf(preview),
                      .notes = notesOf(preview),
                      .refusal = text(preview.refusal)};
    if (!preview.leveled.map.heights.empty()) {
        shown.after = heightPicture(preview.leveled.map);
    }
    return shown;
}

}  // namespace asperity
