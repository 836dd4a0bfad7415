#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

namespace asperity {

WindowMenus::WindowMenus(QMenuBar& bar) : QObject(&bar) {
    addFileMenu(bar);
    addRunMenu(bar);
    addDeviceMenu(bar);
    addViewMenu(bar);
    addHelpMenu(bar);
}

void WindowMenus::addFileMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("&File"));
    open = menu->addAction(tr("&Open scan or scene…"));
    open->setShortcut(QKeySequence::Open);
    cancelLoading = menu->addAction(tr("&Cancel loading"));
    savePicture = menu->addAction(tr("&Save picture of the window…"));
    savePicture->setShortcut(QKeySequence::Save);
    record = menu->addAction(tr("&Record"));
    record->setCheckable(true);
    record->setShortcut(tr("Ctrl+R"));
    saveLastSeconds = menu->addAction(tr("Save the &last seconds"));
    menu->addSeparator();
    quit = menu->addAction(tr("&Quit"));
    quit->setShortcut(QKeySequence::Quit);
}

void WindowMenus::addRunMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("&Run"));
    startPause = menu->addAction(tr("Start or &pause"));
    startPause->setShortcut(tr("Space"));
    forcesOff = menu->addAction(tr("&Forces off"));
    resetFault = menu->addAction(tr("Take &back a fault"));
    menu->addSeparator();
    followPathFile = menu->addAction(tr("Follow a path from a &file…"));
    followRecording = menu->addAction(tr("Repeat a &recording…"));
    for (QAction* action : {startPause, forcesOff}) {
        action->setShortcutContext(Qt::ApplicationShortcut);
    }
}

void WindowMenus::addDeviceMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("H&and"));
    menu->setToolTipsVisible(true);
    tipControl = menu->addAction(tr("Commands the &tip"));
    tipControl->setToolTip(tr("The base goes ahead by the deflection that the model expects"));
    clutch = menu->addAction(tr("&Clutch"));
    clutch->setShortcut(tr("C"));
    clutch->setToolTip(tr("The hand moves, the tip stays; the force comes on anew afterwards"));
    followsView = menu->addAction(tr("Device follows the &view"));
    followsView->setToolTip(tr("Right, away and up of the device are those of the screen"));
    for (QAction* action : {tipControl, clutch, followsView}) {
        action->setCheckable(true);
    }
    addGuides(*menu->addMenu(tr("&Guide")));
    menu->addSeparator();
    calibrate = menu->addAction(tr("C&alibrate: the handle is in its rest pose"));
}

void WindowMenus::addGuides(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    const auto add = [&](FixtureKind kind, const QString& text) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        menu.addAction(action);
        guides_[kind] = action;
        connect(action, &QAction::triggered, this, [this, kind] { Q_EMIT guideChosen(kind); });
    };
    add(FixtureKind::None, tr("&None"));
    add(FixtureKind::Point, tr("&Point where the tip is"));
    add(FixtureKind::Line, tr("Upright &line through the tip"));
    add(FixtureKind::Plane, tr("Level p&lane through the tip"));
    setGuide(FixtureKind::None);
}

void WindowMenus::setGuide(FixtureKind kind) { guides_.at(kind)->setChecked(true); }

void WindowMenus::addViewMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("&View"));
    zoomIn = menu->addAction(tr("Zoom &in"));
    zoomIn->setShortcut(QKeySequence::ZoomIn);
    zoomOut = menu->addAction(tr("Zoom &out"));
    zoomOut->setShortcut(QKeySequence::ZoomOut);
    resetView = menu->addAction(tr("&Reset the view"));
    resetView->setShortcut(tr("Home"));
    addMagnifications(*menu->addMenu(tr("&Displacement drawn larger")));
    menu->addSeparator();
    fidelity = menu->addAction(tr("&Fidelity…"));
    fidelity->setShortcut(tr("F6"));
    parameters = menu->addAction(tr("Scene &parameters…"));
    parameters->setShortcut(tr("F7"));
}

void WindowMenus::addMagnifications(QMenu& menu) {
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& text, std::optional<double> factor) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        menu.addAction(action);
        connect(action, &QAction::triggered, this,
                [this, factor] { Q_EMIT magnificationChosen(factor); });
        return action;
    };
    add(tr("As fits"), std::nullopt)->setChecked(true);
    for (const int factor : {1, 2, 5, 10, 20, 50}) {
        add(QStringLiteral("×%1").arg(factor), factor);
    }
}

void WindowMenus::addHelpMenu(QMenuBar& bar) {
    QMenu* menu = bar.addMenu(tr("&Help"));
    controls = menu->addAction(tr("&Mouse and keys"));
    controls->setShortcut(QKeySequence::HelpContents);
    about = menu->addAction(tr("&About Asperity"));
}

}  // namespace asperity
