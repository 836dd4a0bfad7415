#pragma once

#include "app/reports/LoopReport.h"
#include "app/session/RunControl.h"
#include "ui/FrameCounter.h"

#include <QPixmap>

#include <vector>

namespace asperity {

/// Shows a run in the window: every tick to the curves, the latest one in all views.
class ViewControl : public QObject {
public:
    ViewControl(MainWindow& window, RunControl& runs);

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// One frame: the same tick in all views that are drawn in it. There is a run.
    /// @param now monotonic time [s]
    void show(double now);

    /// The whole window as it is now.
    [[nodiscard]] QPixmap picture();

    /// Frames a second of each view since the first one.
    [[nodiscard]] std::vector<ViewRate> rates() const;

private:
    void solveHalfSpace(const Snapshot& latest);
    /// The same tick in the large view and the panels, or only in those that are drawn each time.
    void draw(const Snapshot& latest, bool everywhere);
    /// @param chosen name of the file, with a type or without
    void savePicture(const QString& chosen);

    MainWindow& window_;
    RunControl& runs_;
    int frame_ = 0;        ///< since the panels were drawn
    FrameCounter view_;    ///< of the large view
    FrameCounter panels_;  ///< of the panels beside it
};

}  // namespace asperity
