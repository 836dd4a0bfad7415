#include "app/window/ViewControl.h"

#include "app/window/live/ForcePanel.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/LoopStatusBar.h"
#include "app/window/live/StateBanner.h"
#include "app/window/live/ViewMemory.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/words/SceneWords.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/MessagesPanel.h"
#include "ui/view/ContactShape.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QImageWriter>
#include <QStringList>

#include <utility>

namespace asperity {

namespace {

// Faster than the eye reads numbers, and half of what redrawing the panels costs.
constexpr int kFramesPerPanelFrame = 2;

/// A name without a type gets the usual one.
QString withPictureType(const QString& file) {
    return QFileInfo(file).suffix().isEmpty() ? file + QStringLiteral(".png") : file;
}

/// The types that are written here, of those that people save pictures in: ".png .jpg".
QString pictureTypes() {
    const QList<QByteArray> written = QImageWriter::supportedImageFormats();
    QStringList types;
    for (const char* const type : {"png", "jpg", "jpeg", "tif", "tiff", "bmp", "webp"}) {
        if (written.contains(type)) {
            types << QStringLiteral(".") + QString::fromLatin1(type);
        }
    }
    return types.join(QLatin1Char(' '));
}

/// Why no picture can be written to this file; empty: it can.
QString pictureRefusal(const QString& file) {
    const QByteArray type = QFileInfo(file).suffix().toLower().toLatin1();
    if (!QImageWriter::supportedImageFormats().contains(type)) {
        return ViewControl::tr("%1: no picture can be written with this extension; known are %2")
            .arg(file, pictureTypes());
    }
    try {
        requireWritable(file.toStdString());
        return {};
    } catch (const Error& error) {
        return QString::fromUtf8(error.what());
    }
}

}  // namespace

ViewControl::ViewControl(Stage& stage) : Feature(stage) {
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Show, [this](double /*elapsed*/) { show(monotonicSeconds()); });
    // Views before panels: which of them share the room. The viewpoint after: how large a view is.
    stage.keepInSession({[this](QVariantMap& kept) { keepViews(live_, kept); },
                         [this](const QVariantMap& kept) { restoreViews(live_, kept); }});
    stage.keepInSession({[this](QVariantMap& kept) { host_.keep(kept); },
                         [this](const QVariantMap& kept) { host_.restore(kept); }});
    stage.keepInSession({[this](QVariantMap& kept) { keepViewpoint(live_, kept); },
                         [this](const QVariantMap& kept) { restoreViewpoint(live_, kept); }});
    addEntries();
    // Curves of another material on the same scan stay: they are compared.
    connect(&runs_, &RunControl::begun, this, [this] {
        if (runs_.isOnOtherScan()) {
            live_.forces().forgetCycles();
        }
    });
    runs_.beforeRecording([this]() -> std::function<void()> {
        QVariantMap kept;
        keepViewpoint(live_, kept);
        return [this, kept, curves = live_.forces().keptCurves()] {
            restoreViewpoint(live_, kept);
            curves();
        };
    });
}

void ViewControl::addEntries() {
    Menus& menus = host_.menus();
    const QAction& picture = menus.add({MenuName::File, 1, 10}, "savePicture",
                                       {.text = tr("Save &picture of the window…"),
                                        .tip = tr("Save the whole window as a picture"),
                                        .shortcuts = {tr("F12")}});
    connect(&picture, &QAction::triggered, this, [this] {
        const QString file =
            askWhereToSave(&host_.widget(), {.kind = FileKind::Picture,
                                             .title = tr("Save a picture of the window"),
                                             .suggestion = QStringLiteral("asperity.png"),
                                             .filters = tr("Pictures (*.png)")});
        if (!file.isEmpty()) {
            savePicture(file);
        }
    });
    ViewOptionsMenu& options = live_.viewOptions();
    const auto fixed = [this] { return runs_.fixedBy(); };
    menus.refuseBy(options.action(&ViewOptions::deformation), fixed);
    menus.refuseBy(options.action(&ViewOptions::trueTip), fixed);
    menus.refuseBy(menus.entry("secondView"), [this] {
        return live_.viewOptions().options().deformation ? QString() : runs_.fixedBy();
    });
}

void ViewControl::take(const TickSample& sample) {
    for (RunPanel* const panel : live_.panels()) {
        panel->take(sample);
    }
}

/// The frame shows the newest solution there is; the one it asks for is for a frame to come.
void ViewControl::solveHalfSpace(const Snapshot& latest) {
    HalfSpaceWorker* const worker = runs_.halfSpace();
    if (worker != nullptr && latest.statistics.ticks > 0 &&
        isDrawable(latest.sample.output.model)) {
        worker->ask(latest.sample.output.model);
        const std::shared_ptr<const HalfSpaceAnswer> answer = worker->newest();
        live_.view().setHalfSpace(answer);
        live_.second().setHalfSpace(answer);
        live_.banner().setHalfSpace(answer.get());
    }
}

void ViewControl::show(double now) {
    LiveRun& run = *runs_.run();
    if (!run.loop().running()) {  // frames drawn in a pause are not counted
        view_.rest();
        panels_.rest();
    }
    live_.banner().setEnergyGiven(run.energy().active());
    const Snapshot& latest = runs_.shown();
    solveHalfSpace(latest);
    frame_ = (frame_ + 1) % kFramesPerPanelFrame;
    draw(latest, frame_ == 0);
    if (frame_ == 0) {
        panels_.add(now);
    }
    view_.add(now);
    live_.loopStatus().setFramesPerSecond(view_.rate());
}

void ViewControl::draw(const Snapshot& latest, bool everywhere) {
    for (RunPanel* const panel : live_.panels()) {
        if (everywhere || panel->slowName() == nullptr) {
            panel->show(latest);
        }
    }
    if (everywhere) {  // the arrow's number is that of the panels, which show every second frame
        const std::string written = live_.forces().magnitude().toStdString();
        live_.view().setWrittenForce(written);
        live_.second().setWrittenForce(written);
    }
    live_.view().showSnapshot(latest);
    if (everywhere) {
        live_.second().showSnapshot(latest);
    }
}

std::vector<ViewRate> ViewControl::rates() const {
    std::vector<ViewRate> rates{{"zoom", view_.overallRate()}};
    for (const RunPanel* const panel : live_.panels()) {
        if (panel->slowName() != nullptr) {
            rates.push_back({panel->slowName(), panels_.overallRate()});
        }
    }
    if (!live_.second().isHidden()) {
        rates.push_back({"second", panels_.overallRate()});
    }
    return rates;
}

QPixmap ViewControl::picture() {
    if (runs_.run() != nullptr) {
        runs_.fetch();
        draw(runs_.shown(), true);
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);  // new texts get their room
    return host_.widget().grab();
}

void ViewControl::savePicture(const QString& chosen) {
    const QString file = withPictureType(chosen);
    if (const QString refusal = pictureRefusal(file); !refusal.isEmpty()) {
        host_.complain(refusal);
        return;
    }
    if (picture().save(file)) {
        host_.tell(tr("Saved as %1").arg(file));
    } else {
        host_.complain(tr("%1: the picture cannot be written").arg(file));
    }
}

MessageControl::MessageControl(Stage& stage) : Feature(stage) {
    stage.onFrame(FrameStep::Act, [this](double /*elapsed*/) { advance(); });
    connect(&runs_, &RunControl::begun, this, [this] {
        fault_ = Fault::None;
        listNotes();
    });
    connect(&runs_, &RunControl::modelFitted, this, &MessageControl::listNotes);
}

/// A device that was chosen before it was there is no error.
void MessageControl::advance() {
    const Fault now = runs_.run()->loop().snapshot().sample.output.fault;
    const Fault before = std::exchange(fault_, now);
    if (now == before) {
        return;
    }
    MessageLog& log = host_.messages();
    if (now == Fault::None) {
        log.add(MessageKind::Note, tr("The fault was reset"));
    } else {
        log.add(runs_.run()->awaitsDevice() ? MessageKind::Note : MessageKind::Error,
                tr("Fault, forces are off: %1").arg(coreWords(nameOf(now))));
    }
}

/// The same scan of another material has the same notes on its heights. Those on the force come
/// once its model is known.
void MessageControl::listNotes() {
    const LoadedScene& loaded = runs_.run()->loaded();
    if (loaded.notes != heightNotes_) {
        forceNotes_.clear();
    }
    list(loaded.notes, heightNotes_);
    if (!loaded.needs.pending) {
        list(forceNotes(loaded.scene, loaded.needs), forceNotes_);
    }
}

void MessageControl::list(const std::vector<std::string>& notes, std::vector<std::string>& listed) {
    if (notes != listed) {
        listed = notes;
        for (const std::string& note : notes) {
            host_.messages().add(MessageKind::Note, QString::fromStdString(printable(note)));
        }
    }
}

}  // namespace asperity
