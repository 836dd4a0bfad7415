#pragma once

#include "core/Vector.h"
#include "core/surface/RoundTip.h"
#include "vtkplugins/pictures/OverviewPicture.h"

#include <vtkActor.h>

namespace asperity {

/// Square of the scan that a view shows: it goes with the tip in modest steps and stays within the
/// scan as far as it fits. World frame.
class ViewFrame {
public:
    /// A frame in the middle of a scan of this size [m].
    ViewFrame(double sizeX, double sizeY, double halfWidth);

    /// Half the width [m], at most what shows the whole scan.
    [[nodiscard]] double halfWidth() const { return halfWidth_; }
    void setHalfWidth(double halfWidth);

    /// Keeps `position` within `slack` half widths of the center, along x and along y; goes
    /// straight to a position outside of the frame.
    void follow(const Vector2& position, double slack);

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

/// A square of this half width about a position, cut off at the edges of `inside`; it is moved
/// inside first.
[[nodiscard]] ScanWindow windowAround(const Vector2& position, double halfWidth,
                                      const ScanWindow& inside);

[[nodiscard]] bool holds(const ScanWindow& area, const Vector2& position);
[[nodiscard]] bool sameWindow(const ScanWindow& one, const ScanWindow& other);

/// The space that a view draws: the world, with all that is upright stretched by one factor.
/// Terrain, dent, gap and tip share it, so that what touches in the world touches in the view.
struct DrawnSpace {
    double heightScale = 1.0;  ///< >= 1; 1: true to scale

    [[nodiscard]] Vector3 point(const Vector3& world) const {
        return {world.x(), world.y(), heightScale * world.z()};
    }
    /// Unit normal of what is drawn, of the unit normal of a surface in the world.
    [[nodiscard]] Vector3 normal(const Vector3& world) const {
        return Vector3(world.x(), world.y(), world.z() / heightScale).normalized();
    }
    /// An actor with data in the world frame.
    void apply(vtkActor* actor) const { actor->SetScale(1.0, 1.0, heightScale); }
};

struct ContactPair;
struct Scene;

/// Lengths that set how large a scene is shown: those of its tip, or of its contact where that is
/// as wide as the tip. For a tip that would fill a view of the whole scan, those of the first
/// asperity it meets.
struct ViewScale {
    double patch = 0.0;         ///< half the width of the part that can be deformed [m]
    double usual = 0.0;         ///< half the width of the frame that a scene starts with [m]
    double least = 0.0;         ///< half the width of the closest frame [m]
    double section = 0.0;       ///< half the width that a section starts with [m]
    double leastSection = 0.0;  ///< half the width of the narrowest section [m]
    double pixel = 0.0;         ///< of the scan, its longer side [m]
    /// Distance from the axis to which the tip is drawn as a paraboloid, as a law for paraboloids
    /// requires where contacts are about as wide as the tip; 0: as a sphere [m].
    double paraboloidReach = 0.0;
    double dent = 0.0;   ///< that the setpoint makes, about [m]
    double force = 0.0;  ///< usual one, between setpoint and pull-off [N]
};

[[nodiscard]] ViewScale viewScale(const Scene& scene);

/// Contact radius without load [m]. Source: Johnson, Kendall, Roberts (1971).
[[nodiscard]] double unloadedContactRadius(const ContactPair& pair);

/// Outline of a tip as it is drawn, see vtkAspTipSource: with a shank, and perhaps as a paraboloid.
struct TipOutline {
    RoundTip tip;
    double paraboloidReach = 0.0;  ///< see ViewScale [m]

    /// Distance of the outline from the axis at a height above the apex, >= 0 [m].
    [[nodiscard]] double radius(double height) const;
    /// Half the width of a frame around a tip that is pressed in so deep: none of it leaves the
    /// block of sample through a side [m]. A tip that does not touch needs none.
    [[nodiscard]] double frameAround(double indentation) const;
};

}  // namespace asperity
