#pragma once

class QAction;
class QMenu;

namespace asperity {

/// The entries of the menu Measure.
struct MeasureMenu {
    /// Adds them.
    explicit MeasureMenu(QMenu& menu);

    QAction* profile;
    QAction* roughness;
    QAction* markers;
    QAction* markerHere;  ///< at the cross-hair, which is where the pointer is
    QAction* touches;
    QAction* forceMap;
    QAction* curve;  ///< draws a measured force-distance curve
};

}  // namespace asperity
