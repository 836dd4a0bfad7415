#pragma once

#include "app/reports/LoopReport.h"
#include "app/window/Stage.h"
#include "ui/widgets/FrameCounter.h"

#include <QPixmap>

#include <vector>

namespace asperity {

/// Shows a run in the window: every tick to the curves, the latest one in all views.
class ViewControl : public Feature {
public:
    explicit ViewControl(Stage& stage);

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// One frame: the same tick in all views that are drawn in it. There is a run.
    /// @param now monotonic time [s]
    void show(double now);

    /// Saves the whole window as a picture; says so, or why it cannot be.
    /// @param chosen name of the file, with a type or without
    void savePicture(const QString& chosen);
    /// The whole window as it is now.
    [[nodiscard]] QPixmap picture();

    /// Frames a second of each view since the first one.
    [[nodiscard]] std::vector<ViewRate> rates() const;

private:
    void solveHalfSpace(const Snapshot& latest);
    /// The same tick in the large view and the panels, or only in those that are drawn each time.
    void draw(const Snapshot& latest, bool everywhere);
    void addEntries();

    int frame_ = 0;        ///< since the panels were drawn
    FrameCounter view_;    ///< of the large view
    FrameCounter panels_;  ///< of the panels beside it
};

/// Lists in the window's messages what nobody is shown in a box: faults when they come and go, and
/// what was noted about a scan while it was loaded.
class MessageControl : public Feature {
    Q_OBJECT

public:
    /// @param window, runs outlive this
    explicit MessageControl(Stage& stage);

    /// Once a frame. There is a run.
    void advance();

private:
    void listNotes();
    void list(const std::vector<std::string>& notes, std::vector<std::string>& listed);

    Fault fault_ = Fault::None;             ///< listed last
    std::vector<std::string> heightNotes_;  ///< listed last
    std::vector<std::string> forceNotes_;   ///< listed last
};

}  // namespace asperity
