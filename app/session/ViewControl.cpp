#include "app/session/ViewControl.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"

#include <QCoreApplication>
#include <QEvent>
#include <QFileInfo>
#include <QImageWriter>
#include <QStringList>

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

ViewControl::ViewControl(MainWindow& window, RunControl& runs) : window_(window), runs_(runs) {
    connect(&window, &MainWindow::pictureFileChosen, this, &ViewControl::savePicture);
}

void ViewControl::take(const TickSample& sample) {
    for (RunPanel* const panel : window_.panels()) {
        panel->take(sample);
    }
}

/// The frame shows the newest solution there is; the one it asks for is for a frame to come.
void ViewControl::solveHalfSpace(const Snapshot& latest) {
    HalfSpaceWorker* const worker = runs_.run()->halfSpace();
    if (worker != nullptr && latest.statistics.ticks > 0 &&
        isDrawable(latest.sample.output.model)) {
        worker->ask(latest.sample.output.model);
        const std::shared_ptr<const HalfSpaceAnswer> answer = worker->newest();
        window_.view().setHalfSpace(answer);
        window_.second().setHalfSpace(answer);
        window_.banner().setHalfSpace(answer.get());
    }
}

void ViewControl::show(double now) {
    LiveRun& run = *runs_.run();
    if (!run.loop().running()) {  // what is drawn while it stands still is not counted
        view_.rest();
        panels_.rest();
    }
    window_.banner().setEnergyGiven(run.energy().active());
    const Snapshot& latest = runs_.shown();
    solveHalfSpace(latest);
    frame_ = (frame_ + 1) % kFramesPerPanelFrame;
    draw(latest, frame_ == 0);
    if (frame_ == 0) {
        panels_.add(now);
    }
    view_.add(now);
    window_.loopStatus().setFramesPerSecond(view_.rate());
}

void ViewControl::draw(const Snapshot& latest, bool everywhere) {
    for (RunPanel* const panel : window_.panels()) {
        if (everywhere || panel->slowName() == nullptr) {
            panel->show(latest);
        }
    }
    if (everywhere) {  // the arrow's number is that of the panels, which show every second frame
        const std::string written = window_.forces().magnitude().toStdString();
        window_.view().setWrittenForce(written);
        window_.second().setWrittenForce(written);
    }
    window_.view().showSnapshot(latest);
    if (everywhere) {
        window_.second().showSnapshot(latest);
    }
}

std::vector<ViewRate> ViewControl::rates() const {
    std::vector<ViewRate> rates{{"zoom", view_.overallRate()}};
    for (const RunPanel* const panel : window_.panels()) {
        if (panel->slowName() != nullptr) {
            rates.push_back({panel->slowName(), panels_.overallRate()});
        }
    }
    if (!window_.second().isHidden()) {
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
    return window_.grab();
}

void ViewControl::savePicture(const QString& chosen) {
    const QString file = withPictureType(chosen);
    if (const QString refusal = pictureRefusal(file); !refusal.isEmpty()) {
        window_.complain(refusal);
        return;
    }
    if (picture().save(file)) {
        window_.tell(tr("Saved as %1").arg(file));
    } else {
        window_.complain(tr("%1: the picture cannot be written").arg(file));
    }
}

}  // namespace asperity
