#include "ui/window/MainWindow.h"

#include "core/Version.h"
#include "core/scene/ImagingTip.h"
#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ColourBarWidget.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoadingBar.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QStackedLayout>
#include <QStatusBar>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kGap = 6;         // between panels [px]
constexpr int kLeftShare = 69;  // of the width, against kRightShare
constexpr int kRightShare = 31;
constexpr int kMessageTime = 8000;   // [ms]
constexpr int kColumnMinimum = 372;  // [px]

QString controlsText() {
    return MainWindow::tr(
        "<table cellpadding='3'>"
        "<tr><td><b>Left drag</b></td><td>move the tip along the sample</td></tr>"
        "<tr><td><b>Wheel</b>, <b>Page Up</b>, <b>Page Down</b></td><td>away from the sample and "
        "into it</td></tr>"
        "<tr><td><b>Arrow keys</b></td><td>along the sample, as seen on the screen</td></tr>"
        "<tr><td><b>Shift</b></td><td>a tenth of all that</td></tr>"
        "<tr><td><b>Ctrl + arrows</b></td><td>five times as fast</td></tr>"
        "<tr><td><b>Right drag</b></td><td>turn the view</td></tr>"
        "<tr><td><b>Ctrl + wheel</b>, <b>+</b>, <b>−</b></td><td>zoom</td></tr>"
        "<tr><td><b>Double click</b> on the scan</td><td>travel there</td></tr>"
        "<tr><td><b>Space</b></td><td>pause and go on</td></tr>"
        "<tr><td><b>Esc</b></td><td>forces off; stops loading</td></tr></table>");
}

}  // namespace

MainWindow::MainWindow()
    : menus_(new WindowMenus(*menuBar()))
    , controls_(new ControlBar(this))
    , banner_(new StateBanner(this))
    , view_(new ZoomView(this))
    , heightBar_(new ColourBarWidget(this))
    , displacementBar_(new ColourBarWidget(this))
    , bottomLine_(new QStackedLayout)
    , loading_(new LoadingBar(this))
    , forces_(new ForcePanel(this))
    , cantilever_(new CantileverPanel(this))
    , overview_(new OverviewPanel(this))
    , loopStatus_(new LoopStatusBar(this))
    , fidelity_(new FidelityPanel(this)) {
    setAcceptDrops(true);
    placeAll();
    connectMenus();
    connectView();
    giveFocusBack();
    showScene(nullptr, {});
    showLoading({});
    resize(1600, 1000);
    view_->setFocus();
}

QWidget* MainWindow::leftSide() {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    column->addWidget(banner_);
    column->addWidget(view_, 1);
    auto* bars = new QHBoxLayout;
    bars->setSpacing(3 * kGap);
    bars->addWidget(heightBar_);
    bars->addWidget(displacementBar_);
    column->addLayout(bars);
    column->addLayout(bottomLine());
    return side;
}

/// Both in one place, so that nothing moves when a file is loaded.
QStackedLayout* MainWindow::bottomLine() {
    auto* hint = new QLabel(this);
    hint->setObjectName(QStringLiteral("hint"));
    hint->setText(tr("Drag: move the tip   ·   Wheel: up and down   ·   Right drag: turn   ·   "
                     "Ctrl + wheel: zoom   ·   Esc: forces off"));
    hint->setAlignment(Qt::AlignCenter);
    bottomLine_->addWidget(hint);
    bottomLine_->addWidget(loading_);
    return bottomLine_;
}

QWidget* MainWindow::rightSide() {
    auto* side = new QWidget(this);
    side->setMinimumWidth(kColumnMinimum);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    column->addWidget(forces_, 4);
    column->addWidget(cantilever_, 3);
    column->addWidget(overview_, 3);
    return side;
}

void MainWindow::placeAll() {
    auto* middle = new QWidget(this);
    auto* rows = new QVBoxLayout(middle);
    rows->setContentsMargins(kGap, 0, kGap, 0);
    rows->setSpacing(kGap);
    rows->addWidget(controls_);
    auto* sides = new QHBoxLayout;
    sides->setSpacing(kGap);
    sides->addWidget(leftSide(), kLeftShare);
    sides->addWidget(rightSide(), kRightShare);
    rows->addLayout(sides, 1);
    setCentralWidget(middle);
    statusBar()->addPermanentWidget(loopStatus_);
}

void MainWindow::connectMenus() {
    connect(menus_->open, &QAction::triggered, this, &MainWindow::chooseScan);
    connect(menus_->savePicture, &QAction::triggered, this, &MainWindow::choosePictureFile);
    connect(menus_->followPathFile, &QAction::triggered, this, &MainWindow::choosePath);
    connect(menus_->followRecording, &QAction::triggered, this, &MainWindow::chooseRecording);
    connect(controls_, &ControlBar::pathFileRequested, this, &MainWindow::choosePath);
    connect(menus_->cancelLoading, &QAction::triggered, this, &MainWindow::cancelLoadingRequested);
    connect(loading_, &LoadingBar::cancelRequested, this, &MainWindow::cancelLoadingRequested);
    connect(menus_->quit, &QAction::triggered, this, &QWidget::close);
    connect(menus_->zoomIn, &QAction::triggered, this,
            [this] { view_->setHalfWidth(view_->halfWidth() / 1.25); });
    connect(menus_->zoomOut, &QAction::triggered, this,
            [this] { view_->setHalfWidth(view_->halfWidth() * 1.25); });
    connect(menus_->resetView, &QAction::triggered, view_, &ZoomView::resetCamera);
    connect(menus_, &WindowMenus::magnificationChosen, view_, &ZoomView::setMagnification);
    connect(menus_->fidelity, &QAction::triggered, this, &MainWindow::showFidelity);
    connect(menus_->controls, &QAction::triggered, this, &MainWindow::explainControls);
    connect(menus_->about, &QAction::triggered, this, &MainWindow::explainProgram);
}

void MainWindow::giveFocusBack() {
    const auto toView = [this] { view_->setFocus(); };
    connect(controls_, &ControlBar::runningChosen, this, toView);
    connect(controls_, &ControlBar::forcesChosen, this, toView);
    connect(controls_, &ControlBar::materialChosen, this, toView);
    connect(controls_, &ControlBar::handChosen, this, toView);
    connect(controls_, &ControlBar::pathChosen, this, toView);
    connect(controls_, &ControlBar::recordingChosen, this, toView);
    for (QLineEdit* number : controls_->findChildren<QLineEdit*>()) {
        connect(number, &QLineEdit::returnPressed, this, toView);
    }
}

void MainWindow::connectView() {
    connect(view_, &ZoomView::frameChanged, this, [this] {
        if (const auto window = view_->window()) {
            overview_->showFrame(
                QRectF(QPointF(window->left, window->bottom), QPointF(window->right, window->top)));
        }
    });
    connect(view_, &ZoomView::scalesChanged, this, [this] {
        heightBar_->setScale(view_->heightScale());
        displacementBar_->setScale(view_->displacementScale());
    });
}

void MainWindow::showScene(const Scene* scene, const QString& title) {
    forces_->clear();
    cantilever_->clear();
    overview_->clear();
    banner_->clear();
    loopStatus_->clear();
    if (scene != nullptr) {
        cantilever_->setCantilever(scene->belief.cantilever);
        overview_->setSurface(scene->surface);
        overview_->setScanNote(QString::fromStdString(imagingTipWords(*scene)),
                               QString::fromStdString(imagingTipNote(*scene)));
        loopStatus_->setRateAsked(scene->description.tickRate);
    }
    view_->setScene(scene);
    setWindowTitle(title.isEmpty() ? tr("Asperity") : tr("%1 – Asperity").arg(title));
}

void MainWindow::tell(const QString& message) { statusBar()->showMessage(message, kMessageTime); }

void MainWindow::showLoading(const QString& name) {
    loading_->begin(name);
    bottomLine_->setCurrentIndex(name.isEmpty() ? 0 : 1);
    menus_->cancelLoading->setEnabled(!name.isEmpty());
}

void MainWindow::lock() {
    setAcceptDrops(false);
    controls_->setEnabled(false);
    overview_->setEnabled(false);
    fidelity_->setEnabled(false);
    for (QAction* action : findChildren<QAction*>()) {
        action->setEnabled(action == menus_->quit);
    }
}

void MainWindow::complain(const QString& message) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, tr("Asperity"), message, QMessageBox::Ok, this);
    box->setTextFormat(Qt::PlainText);  // a name of a file may look like markup
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::chooseScan() {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a scan or a scene"), {},
        tr("Scans and scenes (*.toml %1);;All files (*)").arg(scanFiles_.join(QLatin1Char(' '))));
    if (!file.isEmpty()) {
        Q_EMIT openRequested(file);
    }
}

void MainWindow::choosePath() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Follow a path"), {},
                                                      tr("Paths: time_s, x_m, y_m, z_m (*.csv)"));
    if (!file.isEmpty()) {
        Q_EMIT pathFileChosen(file);
    }
}

void MainWindow::chooseRecording() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Repeat a recording"), {},
                                                      tr("Force logs (force_log.csv *.csv)"));
    if (!file.isEmpty()) {
        Q_EMIT recordingChosen(file);
    }
}

void MainWindow::choosePictureFile() {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save a picture of the window"),
                                     QStringLiteral("asperity.png"), tr("Pictures (*.png)"));
    if (!file.isEmpty()) {
        Q_EMIT pictureFileChosen(file);
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    // As a file URI: Qt's own texts lose the bytes of a name that is no UTF-8.
    Q_EMIT openRequested(QString::fromLatin1(event->mimeData()->urls().front().toEncoded()));
}

void MainWindow::showFidelity() {
    fidelity_->show();
    fidelity_->raise();
    fidelity_->activateWindow();
}

void MainWindow::explainControls() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Mouse and keys"), controlsText(),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::explainProgram() {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, tr("About Asperity"),
        tr("<b>Asperity %1</b><br>An augmented-reality interface for an atomic force "
           "microscope.<br>BSD-3-Clause; uses VTK, Qt, Qwt, Eigen, hidapi, OpenEXR.")
            .arg(QString::fromUtf8(kVersion)),
        QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

}  // namespace asperity
