#pragma once

#include "app/LoopReport.h"
#include "core/haptics/Snapshot.h"
#include "ui/FrameCounter.h"

#include <array>
#include <vector>

namespace asperity {

class MainWindow;

/// Shows a run in the window: every tick to the curves, the latest one in all views.
class FrameShow {
public:
    explicit FrameShow(MainWindow& window) : window_(window) {}

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// One frame. @param now monotonic time [s]
    void show(const Snapshot& latest, double now);

    /// The same tick in every view, for a picture of the window.
    void showEverywhere(const Snapshot& latest);

    /// Frames a second of each view since the first one.
    [[nodiscard]] std::vector<ViewRate> rates() const;

private:
    enum View : std::size_t { Zoom, Forces, Cantilever, Overview, ViewCount };

    void showSmallPanel(const Snapshot& latest, double now);

    MainWindow& window_;
    std::size_t turn_ = Overview;  ///< the small panel that was drawn last
    std::array<FrameCounter, ViewCount> counters_;
};

}  // namespace asperity
