#pragma once

#include "app/reports/LoopReport.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/Snapshot.h"
#include "ui/FrameCounter.h"

#include <memory>
#include <vector>

namespace asperity {

class MainWindow;

/// Shows a run in the window: every tick to the curves, the latest one in all views.
class FrameShow {
public:
    explicit FrameShow(MainWindow& window) : window_(window) {}

    /// Every tick, in order.
    void take(const TickSample& sample);
    /// What the half-space says, for the frames to come; or null.
    void setHalfSpace(const std::shared_ptr<const HalfSpaceAnswer>& answer);
    /// Whether a hand with motors is given energy that nobody put in.
    void setEnergyGiven(bool given);
    /// One frame: the same tick in all views that are drawn in it.
    /// @param now monotonic time [s]
    void show(const Snapshot& latest, double now);
    /// The same tick in every view, for a picture of the window.
    void showEverywhere(const Snapshot& latest);
    /// The run stands still: what is drawn meanwhile is not counted.
    void rest();

    /// Frames a second of each view since the first one.
    [[nodiscard]] std::vector<ViewRate> rates() const;

private:
    MainWindow& window_;
    int frame_ = 0;        ///< since the panels were drawn
    FrameCounter view_;    ///< of the large view
    FrameCounter panels_;  ///< of the panels beside it
};

}  // namespace asperity
