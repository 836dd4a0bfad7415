#pragma once

#include "core/scene/VirtualFixture.h"

#include <QObject>

#include <map>
#include <optional>

class QAction;
class QMenu;
class QMenuBar;

namespace asperity {

/// The menus of the window and what stands in them.
class WindowMenus : public QObject {
    Q_OBJECT

public:
    explicit WindowMenus(QMenuBar& bar);

    QAction* open;
    QAction* cancelLoading;
    QAction* savePicture;
    QAction* record;  ///< checkable
    QAction* saveLastSeconds;
    QAction* quit;

    QAction* startPause;
    QAction* forcesOff;
    QAction* resetFault;
    QAction* followPathFile;
    QAction* followRecording;

    QAction* tipControl;   ///< checkable
    QAction* clutch;       ///< checkable
    QAction* followsView;  ///< checkable
    QAction* calibrate;

    QAction* zoomIn;
    QAction* zoomOut;
    QAction* resetView;
    QAction* fidelity;
    QAction* parameters;

    QAction* controls;
    QAction* about;

    /// Shows which guide there is.
    void setGuide(FixtureKind kind);

Q_SIGNALS:
    /// How much larger than life displacements shall be drawn; empty: the view chooses.
    void magnificationChosen(std::optional<double> factor);
    /// A guide through where the tip is now, or none.
    void guideChosen(FixtureKind kind);

private:
    void addFileMenu(QMenuBar& bar);
    void addRunMenu(QMenuBar& bar);
    void addDeviceMenu(QMenuBar& bar);
    void addGuides(QMenu& menu);
    void addViewMenu(QMenuBar& bar);
    void addMagnifications(QMenu& menu);
    void addHelpMenu(QMenuBar& bar);

    std::map<FixtureKind, QAction*> guides_;
};

}  // namespace asperity
