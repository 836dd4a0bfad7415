#include "ui/window/MainWindow.h"

#include "ui/help/CheatSheet.h"
#include "ui/help/WindowHelp.h"
#include "ui/panels/CantileverPanel.h"
#include "ui/panels/ColorBarWidget.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/EngageBar.h"
#include "ui/panels/FidelityPanel.h"
#include "ui/panels/ForcePanel.h"
#include "ui/panels/HapticPanel.h"
#include "ui/panels/LoadingBar.h"
#include "ui/panels/LoopStatusBar.h"
#include "ui/panels/MessageBadge.h"
#include "ui/panels/MessagesPanel.h"
#include "ui/panels/NumberBox.h"
#include "ui/panels/OverviewMap.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/panels/ScenePanel.h"
#include "ui/panels/StateBanner.h"
#include "ui/panels/WorkInBackground.h"
#include "ui/view/ZoomView.h"
#include "ui/window/CardColumn.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/CrossHairLink.h"
#include "ui/window/Dialogs.h"
#include "ui/window/DirectionMenu.h"
#include "ui/window/Maximizer.h"
#include "ui/window/PageTabs.h"
#include "ui/window/PanelsMenu.h"
#include "ui/window/Placement.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewBars.h"
#include "ui/window/ViewSide.h"
#include "ui/window/WindowLayout.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QShortcut>
#include <QStatusBar>

#include <functional>

namespace asperity {

namespace {

constexpr int kMessageTime = 8000;  // [ms]
// At first, where the screen has that much: usual screens are filled, and on larger ones panels
// would only grow emptier.
constexpr QSize kWindowSize(2400, 1500);

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

/// A right click on a color bar chooses other colors.
void openColorsMenu(const ViewBars& bars, ColorsMenu& colors) {
    QObject::connect(&bars, &ViewBars::colorsRequested, &colors,
                     [&colors](const QPoint& at) { colors.menu().popup(at); });
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
    : messages_(new MessageLog(this))
    , menus_(new WindowMenus(*menuBar()))
    , controls_(new ControlBar(this))
    , banner_(new StateBanner(this))
    , engage_(new EngageBar(this))
    , view_(new ZoomView(this))
    , second_(new SecondView(this))
    , loading_(new LoadingBar(this))
    , works_(new WorkInBackground(this))
    , viewSide_(new ViewSide({banner_, engage_, view_, second_, loading_}, this))
    , layout_(new WindowLayout(controls_, viewSide_, this))
    , overview_(new OverviewPanel(this))
    , forces_(new ForcePanel(this))
    , loopStatus_(new LoopStatusBar(this))
    , fidelity_(new FidelityPanel(this))
    , scenePanel_(new ScenePanel(this))
    , hapticPanel_(new HapticPanel(this))
    , cheatSheet_(new CheatSheet([this] { return windowHelp(*menuBar()); }, this)) {
    setAcceptDrops(true);
    placeAll();
    connectMenus();
    connectViews();
    connectWorks();
    giveFocusBack(*controls_, *view_);
    connect(engage_, &EngageBar::setpointEntered, view_, [this] { view_->setFocus(); });
    tellRefusals();
    closeByEscape(*fidelity_);
    closeByEscape(*cheatSheet_);
    showScene(nullptr, {});
    controls_->setEnabled(false);  // until there is something to control
    engage_->setEnabled(false);
    showLoading({});
    setEmergencyStop(false);
    setGeometry(openingPlace(kWindowSize, screen()->availableGeometry()));
    view_->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::placeAll() {
    setCentralWidget(layout_);
    const auto add = [this](auto* card, int share) {
        layout_->addCard(card, share);
        panels_.push_back(card);
    };
    panels_.push_back(banner_);
    add(forces_, 4);
    add(new CantileverPanel(this), 3);
    add(overview_, 3);
    addSidePage(scenePanel_, tr("Scene"));
    addSidePage(hapticPanel_, tr("Haptics"));
    statusBar()->addWidget(loopStatus_, 1);  // a message takes the whole line for a while
    panels_.push_back(loopStatus_);
    placeMessages();
    new PanelsMenu(*menus_->panels, *layout_);
    connect(&layout_->maximizer(), &Maximizer::changed, view_, [this](bool active) {
        if (!active) {
            view_->setFocus();
        }
    });
}

void MainWindow::placeMessages() {
    auto* panel = new MessagesPanel(*messages_, this);
    addTool(panel, tr("Messages"));
    auto* badge = new MessageBadge(*messages_, this);
    statusBar()->addPermanentWidget(badge);
    connect(badge, &MessageBadge::clicked, this, [this, panel] { showTool(panel); });
}

const std::vector<Card*>& MainWindow::cards() const { return layout_->cards().cards(); }

bool MainWindow::isPanelEnlarged() const { return layout_->maximizer().isActive(); }

QSplitter& MainWindow::views() { return viewSide_->views(); }

std::optional<Vector2> MainWindow::crossHair() const { return crossHair_->place(); }

void MainWindow::addTool(QWidget* page, const QString& title) {
    layout_->tools().addPage(page, title, false);
}

void MainWindow::showTool(QWidget* page) {
    layout_->maximizer().restore();
    layout_->tools().showPage(page);
}

void MainWindow::addSidePage(QWidget* page, const QString& title) {
    layout_->sidePages().addPage(page, title, true);
}

void MainWindow::showSidePage(QWidget* page) {
    layout_->maximizer().restore();
    layout_->sidePages().showPage(page);
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
    const auto tellRefusal = [this](const QString& reason) { tell(reason, MessageKind::Warning); };
    connect(scenePanel_, &ScenePanel::refused, this, tellRefusal);
    for (const NumberBox* box : findChildren<NumberBox*>()) {
        if (box->window() == this) {
            connect(box, &NumberBox::refused, this, tellRefusal);
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
    const auto askSceneFile = [this](QWidget* window) {
        Q_EMIT sceneFileWanted();
        return askForSession(window, sceneFile_);
    };
    on(menus_->saveSessionAs, ask(askSceneFile, &MainWindow::sceneFileChosen));
    on(menus_->savePicture, ask(askForPicture, &MainWindow::pictureFileChosen));
    const auto askPath = ask(askForPath, &MainWindow::pathFileChosen);
    on(menus_->followPathFile, askPath);
    connect(controls_, &ControlBar::pathFileRequested, this, askPath);
    on(menus_->followRecording, ask(askForRecording, &MainWindow::recordingChosen));
    on(menus_->lookAtRecording, ask(askForRun, &MainWindow::runChosen));
    for (ZoomView* const view : {view_, &second_->space()}) {
        view->addAction(menus_->copyView);  // so that its shortcut holds there
    }
    on(menus_->quit, [this] { close(); });
    on(menus_->zoomIn, [this] { view_->setHalfWidth(view_->halfWidth() / 1.25); });
    on(menus_->zoomOut, [this] { view_->setHalfWidth(view_->halfWidth() * 1.25); });
    on(menus_->resetView, [this] { view_->resetCamera(); });
    connect(menus_, &WindowMenus::viewOptionsChosen, view_, &ZoomView::setOptions);
    connect(&menus_->directions(), &DirectionMenu::sideChosen, view_, &ZoomView::lookFrom);
    connect(&menus_->directions(), &DirectionMenu::perspectiveChosen, view_,
            &ZoomView::setPerspective);
    connect(menus_->secondView, &QAction::toggled, second_, &QWidget::setVisible);
    on(menus_->fidelity, [this] { toggle(*fidelity_); });
    on(menus_->parameters, [this] { showSidePage(scenePanel_); });
    on(menus_->controls, [this] { toggle(*cheatSheet_); });
}

void MainWindow::connectViews() {
    showFrameOf(*view_, *overview_);
    openColorsMenu(viewSide_->bars(), menus_->colors());
    openColorsMenu(second_->bars(), menus_->colors());
    ColorBarWidget& whole = overview_->colorBar();
    connect(&whole, &QWidget::customContextMenuRequested, this, [this, &whole](const QPoint& at) {
        menus_->colors().menu().popup(whole.mapToGlobal(at));
    });
    connect(view_, &ZoomView::scalesChanged, this, [this] {
        const ColorScale shown = view_->colorScale();
        menus_->colors().setShown(shown.unit, shown.low, shown.high);
    });
    crossHair_ = std::make_unique<CrossHairLink>(*view_, *second_, overview_->map());
    // The second view moves the tip as the large one does.
    connect(&second_->space(), &ZoomView::tipDragged, view_, &ZoomView::tipDragged);
    connect(&second_->space(), &ZoomView::lifted, view_, &ZoomView::lifted);
}

void MainWindow::showLook(const SurfaceLook& look, const SurfaceField& field) {
    view_->setLook(look, field);
    second_->setLook(look, field);
    overview_->setLook(look, field);
    menus_->colors().setLook(look);
}

void MainWindow::showScene(const Scene* scene, const QString& title) {
    for (RunPanel* const panel : panels_) {
        panel->clear();
        if (scene != nullptr) {
            panel->begin(*scene);
        }
    }
    if (scene != nullptr && !hasShownScene_) {
        hasShownScene_ = true;
        controls_->setEnabled(true);
        engage_->setEnabled(true);
    }
    view_->setScene(scene);
    second_->setScene(scene);
    setWindowTitle(title.isEmpty() ? tr("Asperity") : tr("%1 – Asperity").arg(title));
}

void MainWindow::tell(const QString& message) { tell(message, MessageKind::Note); }

void MainWindow::tell(const QString& message, MessageKind kind) {
    statusBar()->showMessage(message, kMessageTime);
    if (!message.isEmpty()) {
        messages_->add(kind, message);
    }
}

void MainWindow::connectWorks() {
    connect(works_, &WorkInBackground::named, this, &MainWindow::showLoading);
    connect(works_, &WorkInBackground::progressed, loading_, &LoadingBar::setFraction);
    connect(loading_, &LoadingBar::cancelRequested, works_, &WorkInBackground::cancel);
    connect(menus_->cancelLoading, &QAction::triggered, works_, &WorkInBackground::cancel);
}

void MainWindow::showLoading(const QString& words) {
    loading_->begin(words);
    viewSide_->setLoading(!words.isEmpty());
    menus_->cancelLoading->setEnabled(!words.isEmpty());
}

void MainWindow::setEmergencyStop(bool active) {
    menus_->forcesOff->setShortcut(active ? QKeySequence(Qt::Key_Escape) : QKeySequence());
    for (QShortcut* escape : toolClosers_) {
        escape->setEnabled(!active);
    }
    layout_->maximizer().setEscape(!active);
    hasEmergencyStop_ = active;
    showHint();
}

void MainWindow::refuseTip(const QString& why) {
    controls_->refuseTip(why);
    tipMoves_ = why.isEmpty();
    showHint();
}

void MainWindow::fix(const QString& why) {
    isFixed_ = !why.isEmpty();
    controls_->fix(why);
    crossHair_->setOn(!isFixed_);  // nothing is looked for with the pointer
    allowChanges(!isFixed_);
}

void MainWindow::allowChanges(bool allowed) {
    setAcceptDrops(allowed);
    for (QWidget* panel : QWidgetList{scenePanel_, hapticPanel_, fidelity_, engage_}) {
        panel->setEnabled(allowed);
    }
}

void MainWindow::showHint() {
    QString hint = tr("Right drag: turn   ·   Ctrl + wheel: zoom");
    if (tipMoves_) {
        hint = tr("Drag: move the tip   ·   Wheel: up and down   ·   %1").arg(hint);
    }
    viewSide_->setHint(hasEmergencyStop_ ? tr("%1   ·   Esc: forces off").arg(hint) : hint);
}

void MainWindow::lock() {
    allowChanges(false);
    controls_->setEnabled(false);
    overview_->setEnabled(false);
    menus_->lock();
    for (QAction* action : findChildren<QAction*>()) {
        action->setEnabled(action == menus_->quit);
    }
}

void MainWindow::complain(const QString& message) {
    messages_->add(MessageKind::Error, message);
    complainIn(this, message);
}

/// QStatusBar hides what a message covers only where that is on the screen already.
void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (const QString message = statusBar()->currentMessage(); !message.isEmpty()) {
        statusBar()->clearMessage();
        statusBar()->showMessage(message, kMessageTime);
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
