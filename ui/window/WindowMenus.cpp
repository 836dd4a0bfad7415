#include "ui/window/WindowMenus.h"

#include "ui/window/ColorsMenu.h"
#include "ui/window/DirectionMenu.h"
#include "ui/window/RecentMenu.h"
#include "ui/window/ThemeMenu.h"
#include "ui/window/ViewOptionsMenu.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include <initializer_list>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kTip = "tip";  ///< property: what an entry says while it works

void explain(QAction& entry, const QString& tip) {
    entry.setProperty(kTip, tip);
    if (entry.isEnabled()) {  // else it says why it is not
        entry.setToolTip(tip);
    }
}

/// A menu that shows why an entry does not work.
QMenu* addMenu(QMenuBar& bar, const QString& title) {
    QMenu* menu = bar.addMenu(title);
    menu->setToolTipsVisible(true);
    return menu;
}

}  // namespace

WindowMenus::WindowMenus(QMenuBar& bar) : QObject(&bar) {
    addFileMenu(bar);
    addEditMenu(bar);
    addRunMenu(bar);
    addDeviceMenu(bar);
    addViewMenu(bar);
    measure_.emplace(*addMenu(bar, tr("&Measure")));
    addHelpMenu(bar);
    explainAll();
    refuse(*trial, tr("No study is under way: Run > Study"));  // Return is everybody's
    setHistory({}, {});
}

/// What each entry does; those that others explain are not named here.
void WindowMenus::explainAll() {
    const std::initializer_list<std::pair<QAction*, QString>> tips{
        {open, tr("Open a height-map file or a scene")},
        {aboutScan, tr("Where the scan comes from, and what was done to it")},
        {cancelLoading, tr("Stop loading; the scene stays as it is")},
        {saveSession,
         tr("Write scene, views and panels as they are now to the file of the session")},
        {saveSessionAs, tr("Write scene, views and panels as they are now to a file (.toml), which "
                           "opens as they are")},
        {restoreSession, tr("Open the session before this one as it was at its end")},
        {startWithSession, tr("Without a file, the program opens the last session")},
        {savePicture, tr("Save the whole window as a picture")},
        {exportView, tr("Write a view, a plot, a field, the surface or a film, as you choose")},
        {record, tr("Write every tick to a folder, until it is chosen again")},
        {compactRecordings, tr("Recordings are packed at their end into an HDF5 file of a tenth of "
                               "the size, for Python, which replays as well")},
        {saveLastSeconds, tr("Save the last 10 s of the run as a recording")},
        {bundle, tr("Put the last recording, or the last 10 s, with scan and picture into one file "
                    "(.zip), which opens and replays on any machine")},
        {quit, tr("End the run and close the window")},
        {undo, tr("The scene as it was before its last change")},
        {redo, tr("The scene as it was before the last undo")},
        {copyView, tr("Put the picture of the large view on the clipboard")},
        {copyWindow, tr("Put the picture of the window on the clipboard")},
        {copyPlot,
         tr("Put the plot under the pointer on the clipboard, as picture and as numbers")},
        {copyNumbers,
         tr("Put all numbers shown on the clipboard: tab-separated, with standard deviations")},
        {startPause, tr("Start the run, or pause it")},
        {forcesOff, tr("Switch the forces on the device off")},
        {resetFault, tr("Reset the fault: forces act again")},
        {followPathFile, tr("Move the base along a path from a CSV file")},
        {followRecording, tr("Move the base as in a recorded run")},
        {lookAtRecording, tr("Show any moment of a recorded run, or of a bundle, in all views")},
        {study, tr("Positioning experiments with people: tasks, trials, results")},
        {trial, tr("The trial of the study begins, or ends where the tip is")},
        {calibrate, tr("Set the zero of the device's angles")},
        {zoomIn, tr("Show a smaller part of the scan")},
        {zoomOut, tr("Show a larger part of the scan")},
        {resetView, tr("Direction and width as at first")},
        {secondView,
         tr("Beside the large view: a section through the contact, or a 3-D view with a "
            "direction and options of its own")},
        {fidelity, tr("Terms of the model with their errors and costs")},
        {parameters, tr("Every key of the scene: scan, material, tip, lever, physics")},
        {controls, tr("All keys and all that the mouse does, to be searched and printed")},
        {about, tr("Versions and licenses of the program and its libraries")}};
    for (const auto& [entry, tip] : tips) {
        explain(*entry, tip);
    }
    for (const auto& [kind, entry] : guides_) {
        explain(*entry, kind == FixtureKind::None
                            ? tr("The device is free: nothing holds it at a place")
                            : tr("Help the device to hold this place"));
    }
}

void WindowMenus::addFileMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&File"));
    open = menu->addAction(tr("&Open scan or scene…"));
    open->setShortcut(QKeySequence::Open);
    recent = new RecentMenu(*menu);
    channels_ = menu->addMenu(tr("C&hannel"));
    channels_->setObjectName(QStringLiteral("channels"));
    channels_->setToolTipsVisible(true);
    setChannels({}, {});
    aboutScan = menu->addAction(tr("About &this scan…"));
    cancelLoading = menu->addAction(tr("C&ancel loading"));
    saveSession = menu->addAction(tr("&Save session"));
    saveSession->setShortcut(QKeySequence::Save);
    saveSessionAs = menu->addAction(tr("Sa&ve session as…"));
    saveSessionAs->setShortcut(tr("Ctrl+Shift+S"));
    restoreSession = menu->addAction(tr("Restore the session &before"));
    startWithSession = menu->addAction(tr("Start &with the last session"));
    startWithSession->setCheckable(true);
    startWithSession->setChecked(true);
    menu->addSeparator();
    savePicture = menu->addAction(tr("Save &picture of the window…"));
    savePicture->setShortcut(tr("F12"));
    exportView = menu->addAction(tr("E&xport…"));
    exportView->setShortcut(tr("Ctrl+E"));
    record = menu->addAction(tr("&Record"));
    record->setCheckable(true);
    record->setShortcut(tr("Ctrl+R"));
    compactRecordings = menu->addAction(tr("Compact recordin&gs (HDF5)"));
    compactRecordings->setCheckable(true);
    saveLastSeconds = menu->addAction(tr("Save the &last 10 s (black box)"));
    bundle = menu->addAction(tr("B&undle the last recording"));
    bundle->setShortcut(tr("Ctrl+B"));
    menu->addSeparator();
    quit = menu->addAction(tr("&Quit"));
    quit->setShortcut(QKeySequence::Quit);
}

void WindowMenus::addEditMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&Edit"));
    undo = menu->addAction(QString());
    undo->setObjectName(QStringLiteral("undo"));
    undo->setShortcut(tr("Ctrl+Z"));
    redo = menu->addAction(QString());
    redo->setObjectName(QStringLiteral("redo"));
    redo->setShortcuts({QKeySequence(tr("Ctrl+Shift+Z")), QKeySequence(tr("Ctrl+Y"))});
    menu->addSeparator();
    copyView = menu->addAction(tr("&Copy view"));
    copyView->setShortcut(QKeySequence::Copy);
    copyView->setShortcutContext(Qt::WidgetShortcut);  // number fields copy what they hold
    copyWindow = menu->addAction(tr("Copy &window"));
    copyPlot = menu->addAction(tr("Copy &plot"));
    copyPlot->setShortcut(tr("Ctrl+Shift+C"));
    copyNumbers = menu->addAction(tr("Copy r&eadings"));
}

void WindowMenus::setHistory(const QString& undoName, const QString& redoName) {
    const auto show = [this](QAction& entry, const QString& text, const QString& name,
                             const QString& reason) {
        const QString plain = QString(name).replace('&', QStringLiteral("&&"));
        entry.setText(text.arg(plain).trimmed());
        refuse(entry, name.isEmpty() ? reason : QString());
    };
    show(*undo, tr("&Undo %1"), undoName, tr("The scene has not been changed"));
    show(*redo, tr("&Redo %1"), redoName, tr("Nothing has been undone"));
}

void WindowMenus::addRunMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&Run"));
    startPause = menu->addAction(tr("Start or &pause"));
    startPause->setShortcut(tr("Space"));
    forcesOff = menu->addAction(tr("&Forces off"));
    resetFault = menu->addAction(tr("Reset fa&ult"));
    menu->addSeparator();
    followPathFile = menu->addAction(tr("Follow a path from a fi&le…"));
    followRecording = menu->addAction(tr("Replay a &recording…"));
    lookAtRecording = menu->addAction(tr("Look at a rec&ording…"));
    menu->addSeparator();
    study = menu->addAction(tr("Stud&y…"));
    trial = menu->addAction(tr("&Begin or end a trial"));
    trial->setShortcuts({QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)});
    trial->setAutoRepeat(false);
    for (QAction* action : {startPause, forcesOff}) {
        action->setShortcutContext(Qt::ApplicationShortcut);
    }
}

void WindowMenus::addDeviceMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&Device"));
    tipControl = menu->addAction(tr("&Tip position control"));
    explain(*tipControl,
            tr("The device commands the tip: the expected deflection is added to the base"));
    clutch = menu->addAction(tr("&Clutch"));
    clutch->setShortcut(tr("C"));
    explain(*clutch,
            tr("Move the device while the tip stays; the force ramps up again afterwards"));
    followsView = menu->addAction(tr("Device follows the &view"));
    explain(*followsView,
            tr("Right, back and up on the device are right, back and up on the screen"));
    for (QAction* action : {tipControl, clutch, followsView}) {
        action->setCheckable(true);
    }
    addGuides(*menu->addMenu(tr("&Guide")));
    menu->addSeparator();
    calibrate = menu->addAction(tr("C&alibrate (handle in its rest pose)"));
}

void WindowMenus::addGuides(QMenu& menu) {
    menu.setToolTipsVisible(true);
    auto* group = new QActionGroup(&menu);
    const auto add = [&](FixtureKind kind, const QString& text) {
        QAction* action = group->addAction(text);
        action->setCheckable(true);
        menu.addAction(action);
        guides_[kind] = action;
        connect(action, &QAction::triggered, this, [this, kind] { Q_EMIT guideChosen(kind); });
    };
    add(FixtureKind::None, tr("&None"));
    add(FixtureKind::Point, tr("&Point at the tip"));
    add(FixtureKind::Line, tr("Vertical &line through the tip"));
    add(FixtureKind::Plane, tr("&Horizontal plane through the tip"));
    setGuide(FixtureKind::None);
}

void WindowMenus::setGuide(FixtureKind kind) { guides_.at(kind)->setChecked(true); }

void WindowMenus::setChannels(const QStringList& names, const QString& present) {
    delete channelGroup_;
    channels_->clear();
    channelGroup_ = new QActionGroup(channels_);
    for (const QString& name : names) {
        QAction* entry = channelGroup_->addAction(QString(name).replace('&', QStringLiteral("&&")));
        entry->setProperty("namedByData", true);
        entry->setCheckable(true);
        entry->setChecked(name == present);
        channels_->addAction(entry);
        entry->setToolTip(tr("Open the channel “%1” of the file").arg(name.toHtmlEscaped()));
        connect(entry, &QAction::triggered, this, [this, name] { Q_EMIT channelChosen(name); });
    }
    refuse(*channels_->menuAction(),
           names.size() > 1 ? QString() : tr("The file holds no other height channel"));
}

void WindowMenus::refuse(QAction& entry, const QString& reason) {
    const auto known = refusals_.find(&entry);
    if (locked_ || (known != refusals_.end() && known->second == reason)) {
        return;
    }
    refusals_[&entry] = reason;
    if (!entry.property(kTip).isValid()) {  // one that another menu has explained
        explain(entry, entry.toolTip());
    }
    entry.setEnabled(reason.isEmpty());
    entry.setToolTip(reason.isEmpty() ? entry.property(kTip).toString() : reason);
}

void WindowMenus::refuseGuides(const QString& reason) {
    for (const auto& [kind, entry] : guides_) {
        if (kind != FixtureKind::None) {
            refuse(*entry, reason);
        }
    }
}

void WindowMenus::addViewMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&View"));
    zoomIn = menu->addAction(tr("Zoom &in"));
    zoomIn->setShortcut(QKeySequence::ZoomIn);
    zoomOut = menu->addAction(tr("Zoom &out"));
    zoomOut->setShortcut(QKeySequence::ZoomOut);
    resetView = menu->addAction(tr("&Reset the view"));
    resetView->setShortcut(tr("Home"));
    menu->addSeparator();
    directions_ = new DirectionMenu(*menu->addMenu(tr("&Direction")), DirectionMenu::Keys::Digits);
    secondView = menu->addAction(tr("Second vie&w"));
    secondView->setCheckable(true);
    menu->addSeparator();
    colors_ = new ColorsMenu(*menu->addMenu(tr("&Colors")));
    viewOptions_ = new ViewOptionsMenu(*menu);
    connect(viewOptions_, &ViewOptionsMenu::optionsChosen, this, &WindowMenus::viewOptionsChosen);
    menu->addSeparator();
    fidelity = menu->addAction(tr("&Fidelity…"));
    fidelity->setShortcut(tr("F6"));
    parameters = menu->addAction(tr("Sce&ne"));
    parameters->setShortcut(tr("F7"));
    menu->addSeparator();
    panels = menu->addMenu(tr("&Panels"));
    new ThemeMenu(*menu->addMenu(tr("&Theme")));
}

void WindowMenus::addHelpMenu(QMenuBar& bar) {
    QMenu* menu = addMenu(bar, tr("&Help"));
    controls = menu->addAction(tr("&Keyboard and mouse"));
    controls->setShortcut(QKeySequence::HelpContents);
    about = menu->addAction(tr("&About Asperity"));
}

}  // namespace asperity
