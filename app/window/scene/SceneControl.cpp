#include "app/window/scene/SceneControl.h"

#include "app/program/LoadedScene.h"
#include "app/recording/Bundle.h"
#include "app/runs/RunFolder.h"
#include "app/window/UnpackedRun.h"
#include "app/window/WindowSection.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/scene/SceneFile.h"
#include "core/surface/GivenScale.h"
#include "core/words/SceneWords.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <memory>
#include <utility>

namespace asperity {

namespace {

/// Loads a file; of a bundle its scene. @param read (scene) -> LoadedScene
template <class Read>
LoadedScene loadedOf(const std::filesystem::path& input, Progress& progress, const Read& read) {
    if (!isBundle(input)) {
        return read(input);
    }
    ProgressPart unpacking(&progress, 0.0, 0.3);
    const std::filesystem::path folder = unpackedRun(input, &unpacking);
    return readStaying(input, folder, [&] { return read(folder / run_files::kScene); });
}

}  // namespace

ScanReportControl::ScanReportControl(Stage& stage) : Feature(stage) {
    const QAction& entry = host_.menus().add({MenuName::File, 0, 40}, "aboutScan",
                                             {.text = tr("About &this scan…"),
                                              .tip = tr("Origin and processing of the scan"),
                                              .refusal = [this] { return runs_.showRefusal(); }});
    connect(&entry, &QAction::triggered, this, &ScanReportControl::open);
    connect(&runs_, &RunControl::begun, this, &ScanReportControl::refresh);
    connect(&runs_, &RunControl::modelFitted, this, &ScanReportControl::refresh);
    connect(&edits_, &SceneEdits::changed, this, &ScanReportControl::refresh);
}

void ScanReportControl::open() {
    if (runs_.run() == nullptr) {
        return;
    }
    if (dialog_ == nullptr) {
        dialog_ = new TextDialog(tr("About this scan"),
                                 tr("Origin and processing of the open scan"), &host_.widget());
        dialog_->setObjectName(QStringLiteral("scanReport"));
    }
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    refresh();
}

void ScanReportControl::refresh() {
    if (dialog_ != nullptr && dialog_->isVisible()) {
        dialog_->setText(QString::fromStdString(scanReport(runs_.loaded())));
    }
}

SceneControl::SceneControl(Stage& stage) : SceneOpener(stage), scales_(stage.host()) {
    stage.setScenes(*this);
    host_.onDrop([this](const QString& file) {
        const std::string text = file.toStdString();
        open(pathFromText(text).value_or(text));
    });
    stage.keepInSession(
        {[this](QVariantMap& kept) { keepTip(runs_.run()->basePosition().head<2>(), kept); }, {}});
    addEntries();
    connect(&scales_, &ScaleControl::given, this, [this](const GivenScale& scale) {
        const Retry retry = retry_;
        retry(scale);
    });
    connect(&scales_, &ScaleControl::refused, this, &SceneControl::openCanceled);
    connect(&edits_, &SceneEdits::scaleMissing, this,
            [this](const std::filesystem::path& file, const ScaleGap& gap, const QString& name,
                   const SceneDescription& next) {
                askForScale(file, gap, [this, name, next](const GivenScale& scale) {
                    SceneDescription scaled = next;
                    scaled.sample.scale = merged(scaled.sample.scale, scale);
                    edits_.change(name, scaled);
                });
            });
    connect(&runs_, &RunControl::begun, this, &SceneControl::showChannels);
    connect(&edits_, &SceneEdits::changed, this, &SceneControl::showChannels);
}

void SceneControl::addEntries() {
    Menus& menus = host_.menus();
    undo_ = &menus.add({MenuName::Edit, 0, 10}, "undo",
                       {.tip = tr("The scene as it was before its last change"),
                        .shortcuts = {tr("Ctrl+Z")},
                        .refusal = [this] {
                            const QString& fixed = runs_.editRefusal();
                            return !edits_.undoName().isEmpty() ? QString()
                                   : !fixed.isEmpty()           ? fixed
                                                      : tr("The scene has not been changed");
                        }});
    redo_ = &menus.add({MenuName::Edit, 0, 20}, "redo",
                       {.tip = tr("The scene as it was before the last undo"),
                        .shortcuts = {tr("Ctrl+Shift+Z"), tr("Ctrl+Y")},
                        .refusal = [this] {
                            return edits_.redoName().isEmpty() ? tr("Nothing has been undone")
                                                               : QString();
                        }});
    channels_ = &menus.addMenu({MenuName::File, 0, 30}, "channels", tr("C&hannel"));
    menus.refuseBy(*channels_->menuAction(), [this] {
        return channels_->actions().size() > 1 ? QString()
                                               : tr("The file has no other height channel");
    });
    connect(undo_, &QAction::triggered, &edits_, &SceneEdits::undo);
    connect(redo_, &QAction::triggered, &edits_, &SceneEdits::redo);
    connect(&edits_, &SceneEdits::changed, this, &SceneControl::showHistory);
    connect(&runs_, &RunControl::begun, this, &SceneControl::showHistory);
    showHistory();
}

void SceneControl::showHistory() {
    const auto show = [](QAction& entry, const QString& text, const QString& name) {
        entry.setText(text.arg(QString(name).replace('&', QStringLiteral("&&"))).trimmed());
    };
    show(*undo_, tr("&Undo %1"), edits_.undoName());
    show(*redo_, tr("&Redo %1"), edits_.redoName());
    host_.menus().refresh();
}

void SceneControl::open(const std::filesystem::path& input, const SceneOverrides& overrides,
                        const FailureWords& failureWords) {
    askedWith_ = overrides;
    SceneOverrides asked = overrides;
    if (const SceneDescription* const now = edits_.wanted()) {
        asked.like = *now;
    }
    const auto kept = std::make_shared<QVariantMap>();
    const auto isScan = std::make_shared<bool>(false);
    begin(input,
          {.name = {},
           .load =
               [input, asked, kept, isScan, fit = fit_](Progress& progress) {
                   return loadedOf(input, progress, [&](const std::filesystem::path& scene) {
                       *kept = windowSectionOf(scene);
                       *isScan = !isScene(scene);
                       return loadScene(scene, asked, &progress, fit);
                   });
               },
           .position = [kept] { return keptTip(*kept); },
           .opened =
               [this, input, kept, like = asked.like, isScan] {
                   if (like) {
                       if (*isScan) {
                           tellWhatStays(input, *like);
                       } else {
                           host_.tell(tr("%1 · %2").arg(scanInWords(), partsInWords()));
                       }
                   }
                   Q_EMIT opened(input);
                   if (!kept->isEmpty()) {
                       Q_EMIT sessionOpened(input, *kept);
                   }
               },
           .failed = {},
           .canceled = {}},
          failureWords);
}

/// Material, tip, lever and setpoint of the scene that is shown.
QString SceneControl::partsInWords() const {
    const Scene& scene = runs_.run()->scene();
    const SceneDescription& description = scene.description;
    return tr("%1, tip of %2, lever of %3, setpoint of %4")
        .arg(QString::fromStdString(description.sample.material.name)
                 .replace(QLatin1Char('_'), QLatin1Char(' ')),
             siText(description.tip.radius, "m"),
             siText(scene.belief.cantilever.stiffness(), "N/m"), siText(description.setpoint, "N"));
}

QString SceneControl::scanInWords() const {
    return QString::fromStdString(sampleName(runs_.run()->scene().description.sample));
}

/// A height map says nothing of material, tip and lever.
void SceneControl::tellWhatStays(const std::filesystem::path& input,
                                 const SceneDescription& before) {
    const QString name = shownPath(input.filename());
    host_.tell(before.sample.material.maps.any()
                   ? tr("%1 · as before, but the material, which had maps of its scan: %2")
                         .arg(name, partsInWords())
                   : tr("%1 · as before: %2").arg(name, partsInWords()));
}

void SceneControl::open(const std::filesystem::path& input, const LongWork<LoadedScene>::Work& load,
                        const std::function<void()>& shown) {
    begin(input, {.name = {}, .load = load, .opened = shown, .failed = {}, .canceled = {}});
}

void SceneControl::begin(const std::filesystem::path& input, SceneEdits::Opening opening,
                         const FailureWords& failureWords) {
    scales_.withdraw();
    asked_ = input;
    const QString name = shownPath(input.filename());
    opening.name = name;
    opening.opened = [this, opened = opening.opened] {
        Q_EMIT sceneTaken();
        opened();
    };
    opening.failed = [this, failureWords](const std::exception_ptr& reason) {
        fail(reason, failureWords);
    };
    opening.canceled = [this, name] {
        host_.tell(tr("Loading of %1 canceled").arg(name));
        Q_EMIT openCanceled();
    };
    edits_.open(std::move(opening));
}

void SceneControl::cancelOpen() { edits_.cancel(); }

void SceneControl::fail(const std::exception_ptr& reason, const FailureWords& words) {
    if (asksFor(reason)) {
        return;
    }
    openError_ = reason;
    const QString why = reasonOf(reason);
    host_.complain(words ? words(why) : why);
    Q_EMIT openFailed(why);
}

bool SceneControl::asksFor(const std::exception_ptr& reason) {
    try {
        std::rethrow_exception(reason);
    } catch (const MissingScale& missing) {
        askForScale(missing.path(), missing.gap(), [this](const GivenScale& scale) {
            SceneOverrides overrides = askedWith_;
            overrides.scale = merged(overrides.scale, scale);
            open(asked_, overrides);
        });
        return true;
    } catch (...) {
        return false;
    }
}

void SceneControl::askForScale(const std::filesystem::path& file, const ScaleGap& gap,
                               const Retry& retry) {
    retry_ = retry;
    scales_.ask(file, gap);
    Q_EMIT scaleAsked();
}

void SceneControl::chooseChannel(const QString& name) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.sample.channel = name.toStdString();
        edits_.change(tr("Channel: %1").arg(name), next);
    }
}

void SceneControl::showChannels() {
    const SceneDescription* const scene = edits_.wanted();
    if (scene == nullptr) {
        return;
    }
    delete channelGroup_;
    channels_->clear();
    channelGroup_ = new QActionGroup(channels_);
    for (const std::string& channel : runs_.loaded().channels) {
        const QString name = QString::fromStdString(channel);
        QAction* entry = channelGroup_->addAction(QString(name).replace('&', QStringLiteral("&&")));
        entry->setProperty("namedByData", true);
        entry->setCheckable(true);
        entry->setChecked(channel == scene->sample.channel);
        entry->setToolTip(tr("Open the channel “%1” of the file").arg(name.toHtmlEscaped()));
        channels_->addAction(entry);
        connect(entry, &QAction::triggered, this, [this, name] { chooseChannel(name); });
    }
    host_.menus().refresh();
}

}  // namespace asperity
