#pragma once

#include <QObject>

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
    QAction* takeBackFault;
    QAction* tipControl;  ///< checkable
    QAction* followPathFile;
    QAction* followRecording;

    QAction* zoomIn;
    QAction* zoomOut;
    QAction* resetView;
    QAction* fidelity;

    QAction* controls;
    QAction* about;

Q_SIGNALS:
    /// How much larger than life displacements shall be drawn; empty: the view chooses.
    void magnificationChosen(std::optional<double> factor);

private:
    void addFileMenu(QMenuBar& bar);
    void addRunMenu(QMenuBar& bar);
    void addViewMenu(QMenuBar& bar);
    void addMagnifications(QMenu& menu);
    void addHelpMenu(QMenuBar& bar);
};

}  // namespace asperity
