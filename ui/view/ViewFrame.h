#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/OverviewPicture.h"

namespace asperity {

/// Which square of the scan a view shows: it goes with the tip in modest steps and stays within the
/// scan as far as it fits. World frame.
class ViewFrame {
public:
    /// A frame in the middle of a scan of this size [m].
    ViewFrame(double sizeX, double sizeY, double halfWidth);

    /// Half the width [m], at most what shows the whole scan.
    [[nodiscard]] double halfWidth() const { return halfWidth_; }
    void setHalfWidth(double halfWidth);

    /// Keeps `place` within `slack` half widths of the center, along x and along y; goes straight
    /// to a place outside of the frame.
    void follow(const Vector2& place, double slack);

    [[nodiscard]] const Vector2& center() const { return center_; }
    /// The frame, cut off at the scan's edges.
    [[nodiscard]] ScanWindow window() const;

private:
    [[nodiscard]] Vector2 reach() const;
    void stayInside();

    Vector2 size_;  ///< of the scan [m]
    Vector2 center_;
    double halfWidth_;
};

/// A square of this half width about a place, cut off at the edges of `inside`; the place is moved
/// inside first.
[[nodiscard]] ScanWindow windowAround(const Vector2& place, double halfWidth,
                                      const ScanWindow& inside);

[[nodiscard]] bool holds(const ScanWindow& area, const Vector2& place);
[[nodiscard]] bool sameWindow(const ScanWindow& one, const ScanWindow& other);

}  // namespace asperity
