#pragma once

#include "ui/Steady.h"
#include "ui/view/ViewCamera.h"

namespace asperity {

/// The surface that a frame shows.
struct FramedSurface {
    AxisRange heights;         ///< that the picture has room for [m]
    double halfWidth = 0.0;    ///< of the frame [m]
    double heightScale = 1.0;  ///< see DrawnSpace

    /// Middle of the heights, as drawn [m].
    [[nodiscard]] double middle() const { return heightScale * 0.5 * (heights.low + heights.high); }
};

/// The room that a picture makes for the surface in its frame, for the tip above it and for the
/// deepest dent since it was fitted. It seldom changes, so that nothing but the tip moves.
class ViewExtent {
public:
    /// From now on the picture holds what is in the frame at rest, the tip above it and a dent of
    /// the usual depth below.
    /// @param tipHeight as drawn [m] @param dent [m]
    void fit(const FramedSurface& surface, double tipHeight, double dent = 0.0);
    /// Dents so far count no more; another fit is wanted.
    void forget();
    [[nodiscard]] bool isFitWanted() const { return isFitWanted_; }

    /// The block of sample reaches below a place from now on, if it did not before. World z [m].
    /// @return whether it changed
    bool makeRoomFor(double lowest, const FramedSurface& surface);
    /// The camera looks this much lower, as drawn [m].
    void lower(double by) { lowered_ += by; }

    /// World z where the block of sample ends below [m].
    [[nodiscard]] double bottom(const FramedSurface& surface) const;
    /// @param center of the frame, world x, y [m]
    [[nodiscard]] FrameBox box(const FramedSurface& surface, const Vector2& center) const;

private:
    [[nodiscard]] double drawnBottom(const FramedSurface& surface) const;

    double dentDepth_ = 0.0;  ///< of the block below the frame's lowest place, for dents [m]
    FrameBox fitted_;         ///< what the camera makes room for; its middle goes with the frame
    bool isFitWanted_ = true;
    double lowered_ = 0.0;  ///< camera below the middle of the frame, for a deep dent [m]
};

}  // namespace asperity
