#include "ui/window/MainWindow.h"

#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ColorBarWidget.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/EngageBar.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/LoadingBar.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/NumberBox.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/ParameterPanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/view/ZoomView.h"
#include "ui/window/Dialogs.h"
#include "ui/window/Placement.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QStackedLayout>
#include <QStatusBar>
#include <QVBoxLayout>

#include <functional>

namespace asperity {

namespace {

constexpr int kGap = 6;         // between panels [px]
constexpr int kLeftShare = 69;  // of the width, against kRightShare
constexpr int kRightShare = 31;
constexpr int kMessageTime = 8000;   // [ms]
constexpr int kColumnMinimum = 372;  // [px]
constexpr QSize kUsualSize(1600, 1000);

QVBoxLayout* newColumn(QWidget& side) {
    auto* column = new QVBoxLayout(&side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGap);
    return column;
}

/// A column that shrinks to what its panels need before it has to be scrolled.
class PanelColumn : public QWidget {
public:
    using QWidget::QWidget;
    [[nodiscard]] int heightForWidth(int width) const override {
        return layout()->minimumHeightForWidth(width);
    }
};

/// Scrolls a column of panels where the window is too low for it.
QScrollArea* newScroller(QWidget* column, QWidget* window) {
    auto* area = new QScrollArea(window);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(column);
    area->setMinimumWidth(column->minimumWidth() + area->verticalScrollBar()->sizeHint().width());
    return area;
}

/// Hint and loading in one place, so that nothing moves when a file is loaded.
QStackedLayout* newBottomLine(QLabel* hint, QWidget* loading) {
    hint->setObjectName(QStringLiteral("hint"));
    hint->setAlignment(Qt::AlignCenter);
    auto* line = new QStackedLayout;
    line->addWidget(hint);
    line->addWidget(loading);
    return line;
}

/// The keys that move the device work again once a knob is turned.
void giveFocusBack(ControlBar& controls, ZoomView& view) {
    const auto toView = [&view] { view.setFocus(); };
    const auto give = [&](auto chosen) { QObject::connect(&controls, chosen, &view, toView); };
    give(&ControlBar::runningChosen);
    give(&ControlBar::forcesChosen);
    give(&ControlBar::materialChosen);
    give(&ControlBar::deviceChosen);
    give(&ControlBar::pathChosen);
    give(&ControlBar::recordingChosen);
    for (QLineEdit* number : controls.findChildren<QLineEdit*>()) {
        QObject::connect(number, &QLineEdit::returnPressed, &view, toView);
    }
}

/// The overview shows where the view looks.
void showFrameOf(const ZoomView& view, OverviewPanel& overview) {
    QObject::connect(&view, &ZoomView::frameChanged, &overview, [&] {
        if (const auto window = view.window()) {
            overview.showFrame(
                QRectF(QPointF(window->left, window->bottom), QPointF(window->right, window->top)));
        }
    });
}

}  // namespace

MainWindow::MainWindow()
    : menus_(new WindowMenus(*menuBar()))
    , controls_(new ControlBar(this))
    , banner_(new StateBanner(this))
    , engage_(new EngageBar(this))
    , view_(new ZoomView(this))
    , loading_(new LoadingBar(this))
    , hint_(new QLabel(this))
    , bottomLine_(newBottomLine(hint_, loading_))
    , overview_(new OverviewPanel(this))
    , loopStatus_(new LoopStatusBar(this))
    , fidelity_(new FidelityPanel(this))
    , parameters_(new ParameterPanel(this)) {
    setAcceptDrops(true);
    placeAll();
    connectMenus();
    showFrameOf(*view_, *overview_);
    giveFocusBack(*controls_, *view_);
    connect(engage_, &EngageBar::setpointEntered, view_, [this] { view_->setFocus(); });
    tellRefusals();
    closeByEscape(*fidelity_);
    closeByEscape(*parameters_);
    showScene(nullptr, {});
    showLoading({});
    setEmergencyStop(false);
    setGeometry(openingPlace(kUsualSize, screen()->availableGeometry()));
    view_->setFocus();
}

QWidget* MainWindow::leftSide() {
    auto* side = new QWidget(this);
    QVBoxLayout* column = newColumn(*side);
    column->addWidget(banner_);
    panels_.push_back(banner_);
    column->addWidget(engage_);
    column->addWidget(view_, 1);
    auto* bars = new QHBoxLayout;
    bars->setSpacing(3 * kGap);
    auto* heights = new ColorBarWidget(this);
    auto* displacements = new ColorBarWidget(this);
    bars->addWidget(heights);
    bars->addWidget(displacements);
    connect(view_, &ZoomView::scalesChanged, this, [this, heights, displacements] {
        heights->setScale(view_->heightScale());
        displacements->setScale(view_->displacementScale());
    });
    column->addLayout(bars);
    column->addLayout(bottomLine_);
    return side;
}

QWidget* MainWindow::rightSide() {
    auto* side = new PanelColumn(this);
    side->setMinimumWidth(kColumnMinimum);
    QVBoxLayout* column = newColumn(*side);
    const auto add = [this, column](auto* panel, int share) {
        column->addWidget(panel, share);
        panels_.push_back(panel);
        panel->setFoldable();
        cards_.push_back(panel);
    };
    add(new ForcePanel(this), 4);
    add(new CantileverPanel(this), 3);
    add(overview_, 3);
    column->addStretch();
    return newScroller(side, this);
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
    statusBar()->addWidget(loopStatus_, 1);  // a message takes the whole line for a while
    panels_.push_back(loopStatus_);
}

void MainWindow::toggle(QWidget& panel) {
    if (panel.isVisible()) {
        panel.hide();
        return;
    }
    if (placed_.insert(&panel).second) {
        panel.setGeometry(
            placeBeside(frameGeometry(), panel.size(), screen()->availableGeometry()));
    }
    panel.show();
    panel.raise();
    panel.activateWindow();
}

void MainWindow::closeByEscape(QWidget& panel) {
    auto* escape = new QShortcut(Qt::Key_Escape, &panel);
    connect(escape, &QShortcut::activated, &panel, [&panel] {
        for (NumberBox* box : panel.findChildren<NumberBox*>()) {
            box->discardTyped();
        }
        panel.hide();
    });
    toolClosers_.push_back(escape);
}

void MainWindow::tellRefusals() {
    for (const NumberBox* box : findChildren<NumberBox*>()) {
        if (box->window() == this) {
            connect(box, &NumberBox::refused, this, &MainWindow::tell);
        }
    }
}

void MainWindow::connectMenus() {
    const auto ask = [this](const std::function<QString(QWidget*)>& question,
                            void (MainWindow::*chosen)(QString)) {
        return [this, question, chosen] {
            const QString file = question(this);
            if (!file.isEmpty()) {
                Q_EMIT(this->*chosen)(file);
            }
        };
    };
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    const auto askScan = [this](QWidget* window) { return askForScan(window, scanFiles_); };
    on(menus_->open, ask(askScan, &MainWindow::openRequested));
    on(menus_->savePicture, ask(askForPicture, &MainWindow::pictureFileChosen));
    const auto askPath = ask(askForPath, &MainWindow::pathFileChosen);
    on(menus_->followPathFile, askPath);
    connect(controls_, &ControlBar::pathFileRequested, this, askPath);
    on(menus_->followRecording, ask(askForRecording, &MainWindow::recordingChosen));
    on(menus_->quit, [this] { close(); });
    on(menus_->zoomIn, [this] { view_->setHalfWidth(view_->halfWidth() / 1.25); });
    on(menus_->zoomOut, [this] { view_->setHalfWidth(view_->halfWidth() * 1.25); });
    on(menus_->resetView, [this] { view_->resetCamera(); });
    connect(menus_, &WindowMenus::viewOptionsChosen, view_, &ZoomView::setOptions);
    on(menus_->fidelity, [this] { toggle(*fidelity_); });
    on(menus_->parameters, [this] { toggle(*parameters_); });
    on(menus_->controls, [this] { explainControls(this); });
    on(menus_->about, [this] { explainProgram(this); });
}

void MainWindow::showScene(const Scene* scene, const QString& title) {
    for (RunPanel* const panel : panels_) {
        panel->clear();
        if (scene != nullptr) {
            panel->begin(*scene);
        }
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

void MainWindow::setEmergencyStop(bool active) {
    menus_->forcesOff->setShortcut(active ? QKeySequence(Qt::Key_Escape) : QKeySequence());
    for (QShortcut* escape : toolClosers_) {
        escape->setEnabled(!active);
    }
    const QString gestures = tr("Drag: move the tip   ·   Wheel: up and down   ·   "
                                "Right drag: turn   ·   Ctrl + wheel: zoom");
    hint_->setText(active ? tr("%1   ·   Esc: forces off").arg(gestures) : gestures);
}

void MainWindow::showChanging(const QString& name) {
    loading_->beginChange(name);
    bottomLine_->setCurrentIndex(1);
    menus_->cancelLoading->setEnabled(true);
}

void MainWindow::lock() {
    setAcceptDrops(false);
    controls_->setEnabled(false);
    engage_->setEnabled(false);
    overview_->setEnabled(false);
    fidelity_->setEnabled(false);
    menus_->lock();
    parameters_->setEnabled(false);
    for (QAction* action : findChildren<QAction*>()) {
        action->setEnabled(action == menus_->quit);
    }
}

void MainWindow::complain(const QString& message) { complainIn(this, message); }

/// QStatusBar hides what a message covers only where that is on the screen already.
void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (const QString message = statusBar()->currentMessage(); !message.isEmpty()) {
        statusBar()->clearMessage();
        tell(message);
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

}  // namespace asperity
