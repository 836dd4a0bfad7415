#pragma once

#include "core/scene/VirtualFixture.h"
#include "ui/view/ViewOptions.h"
#include "ui/window/MeasureMenu.h"

#include <QObject>
#include <QString>
#include <QStringList>

#include <map>
#include <optional>

class QAction;
class QActionGroup;
class QMenu;
class QMenuBar;

namespace asperity {

class ColorsMenu;
class DirectionMenu;
class RecentMenu;
class ViewOptionsMenu;

/// The menus of the window and what stands in them.
class WindowMenus : public QObject {
    Q_OBJECT

public:
    explicit WindowMenus(QMenuBar& bar);

    QAction* open;
    RecentMenu* recent;
    QAction* aboutScan;
    QAction* cancelLoading;
    QAction* saveSession;
    QAction* saveSessionAs;
    QAction* restoreSession;
    QAction* startWithSession;  ///< checkable
    QAction* savePicture;
    QAction* exportView;
    QAction* record;             ///< checkable
    QAction* compactRecordings;  ///< checkable
    QAction* saveLastSeconds;
    QAction* bundle;
    QAction* quit;

    QAction* undo;
    QAction* redo;
    QAction* copyView;
    QAction* copyWindow;
    QAction* copyPlot;
    QAction* copyNumbers;

    QAction* startPause;
    QAction* forcesOff;
    QAction* resetFault;
    QAction* followPathFile;
    QAction* followRecording;
    QAction* lookAtRecording;
    QAction* study;
    QAction* trial;  ///< begins and ends one

    QAction* tipControl;   ///< checkable
    QAction* clutch;       ///< checkable
    QAction* followsView;  ///< checkable
    QAction* calibrate;

    QAction* zoomIn;
    QAction* zoomOut;
    QAction* resetView;
    QAction* secondView;  ///< checkable
    QAction* fidelity;
    QAction* parameters;
    QMenu* panels;  ///< empty

    [[nodiscard]] const MeasureMenu& measure() const { return *measure_; }

    QAction* controls;
    QAction* about;

    /// Shows which guide there is.
    void setGuide(FixtureKind kind);

    /// Shows which channels of the scan there are to choose from, and which one is open.
    void setChannels(const QStringList& names, const QString& present);

    /// Shows which change of the scene can be undone, which done again; empty: none.
    void setHistory(const QString& undoName, const QString& redoName);

    /// Disables an entry that cannot work now. @param reason that its tool tip says; empty: it can
    void refuse(QAction& entry, const QString& reason);
    /// The same for all guides but none.
    void refuseGuides(const QString& reason);
    [[nodiscard]] ColorsMenu& colors() { return *colors_; }
    [[nodiscard]] ViewOptionsMenu& viewOptions() { return *viewOptions_; }
    [[nodiscard]] DirectionMenu& directions() { return *directions_; }

    /// From now on every entry stays as it is.
    void lock() { locked_ = true; }

Q_SIGNALS:
    void viewOptionsChosen(ViewOptions options);
    /// A guide through where the tip is now, or none.
    void guideChosen(FixtureKind kind);
    void channelChosen(const QString& name);

private:
    void addFileMenu(QMenuBar& bar);
    void addEditMenu(QMenuBar& bar);
    void addRunMenu(QMenuBar& bar);
    void addDeviceMenu(QMenuBar& bar);
    void addGuides(QMenu& menu);
    void addViewMenu(QMenuBar& bar);
    void addHelpMenu(QMenuBar& bar);
    void explainAll();

    std::optional<MeasureMenu> measure_;  ///< always there
    ColorsMenu* colors_ = nullptr;
    ViewOptionsMenu* viewOptions_ = nullptr;
    DirectionMenu* directions_ = nullptr;
    QMenu* channels_;
    QActionGroup* channelGroup_ = nullptr;  ///< of its entries
    std::map<FixtureKind, QAction*> guides_;
    std::map<QAction*, QString> refusals_;  ///< as they are shown
    bool locked_ = false;
};

}  // namespace asperity
