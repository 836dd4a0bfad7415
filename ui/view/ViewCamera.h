#pragma once

#include "core/Vector.h"
#include "ui/widgets/Steady.h"

#include <cstdint>

class vtkCamera;

namespace asperity {

/// Space that a view is to show: a square frame, from the bottom of the block to the tip.
struct FrameBox {
    Vector3 middle = Vector3::Zero();  ///< of the surface in the frame [m]
    double halfWidth = 0.0;            ///< [m]
    double below = 0.0;                ///< of the block below the middle [m]
    double above = 0.0;                ///< of the surface above the middle [m]
    double tipTop = 0.0;               ///< of the tip above the middle [m]
};

/// Parts of a view that are kept free for words beside the frame.
struct WordRoom {
    double under = 0.0;   ///< the frame, of the view's height
    double beside = 0.0;  ///< on the left and on the right, each of the view's width
};

/// Room for the words of axes in a view of this size, in pixels of letters for 96 dots an inch.
[[nodiscard]] WordRoom wordRoom(double width, double height);

/// Directions to look from, named after where the eye is.
enum class ViewDirection : std::uint8_t { Front, Back, Right, Left, Top, Bottom };

/// Eye of a view: it looks at the middle of a frame from any side, turned by the user always from
/// above the surface; without perspective, so that lengths across the view are to scale, or with
/// it.
class ViewCamera {
public:
    /// Turns about the vertical and over the surface [rad].
    void turn(double azimuth, double elevation);
    /// Looks along an axis of the scan.
    void lookFrom(ViewDirection side);
    /// Direction of the eye, from x and above the horizontal [rad].
    [[nodiscard]] double azimuth() const { return azimuth_; }
    [[nodiscard]] double elevation() const { return elevation_; }
    /// Looks from there; an elevation beyond the vertical is none.
    void setDirection(double azimuth, double elevation);
    void setPerspective(bool perspective) { perspective_ = perspective; }
    [[nodiscard]] bool hasPerspective() const { return perspective_; }
    void reset() { *this = {}; }

    /// Unit vectors, world frame: from the frame's middle to the eye, rightwards and upwards.
    [[nodiscard]] Vector3 out() const;
    [[nodiscard]] Vector3 right() const;
    [[nodiscard]] Vector3 up() const;
    /// Apparent length of a height of 1, 0 .. 1: from above it is 0.
    [[nodiscard]] double heightSeen() const;

    /// Points VTK's camera at a frame so that all of it is seen, on any side.
    /// @param aspect width over height of the view
    void apply(vtkCamera* camera, const FrameBox& box, double aspect,
               const WordRoom& words = {}) const;

    /// The move within a horizontal plane that looks like this move across the view, rightwards
    /// and upwards [m]; nothing of an upward move where the plane is seen from its edge.
    [[nodiscard]] Vector3 horizontalMove(double rightwards, double upwards) const;

private:
    double azimuth_ = -1.917;   ///< of the eye, from x [rad]
    double elevation_ = 0.565;  ///< of the eye above the horizontal [rad]
    bool perspective_ = false;
};

/// The surface that a frame shows.
struct FramedSurface {
    AxisRange heights;         ///< that the picture has room for [m]
    double halfWidth = 0.0;    ///< of the frame [m]
    double heightScale = 1.0;  ///< see DrawnSpace

    /// Middle of the heights, as drawn [m].
    [[nodiscard]] double middle() const { return heightScale * 0.5 * (heights.low + heights.high); }
};

/// The room that a picture makes for the surface in its frame, for the tip above it and for the
/// deepest dent of a contact. It seldom changes, so that nothing but the tip moves.
class ViewExtent {
public:
    /// From now on the picture holds what is in the frame at rest, the tip above it and a dent of
    /// the usual depth below.
    /// @param tipHeight as drawn [m] @param dent [m]
    void fit(const FramedSurface& surface, double tipHeight, double dent = 0.0);
    /// Dents so far count no more; another fit is wanted.
    void forget();
    [[nodiscard]] bool isFitWanted() const { return isFitWanted_; }

    /// The block of sample reaches below a height from now on, if it did not before. World z [m].
    /// @return whether it changed
    bool makeRoomFor(double lowest, const FramedSurface& surface);
    /// The tip has left the surface: the block is as thick as it was before the dent.
    /// @return whether it changed
    bool release();
    /// The camera looks this much lower, as drawn [m].
    void lower(double by) { lowered_ += by; }

    /// World z where the block of sample ends below [m].
    [[nodiscard]] double bottom(const FramedSurface& surface) const;
    /// @param center of the frame, world x, y [m]
    [[nodiscard]] FrameBox box(const FramedSurface& surface, const Vector2& center) const;

private:
    [[nodiscard]] double drawnBottom(const FramedSurface& surface) const;

    double dentDepth_ = 0.0;  ///< of the block below the frame's lowest point, for dents [m]
    double usualDent_ = 0.0;  ///< the same, as it was fitted [m]
    FrameBox fitted_;         ///< what the camera makes room for; its middle goes with the frame
    bool isFitWanted_ = true;
    double lowered_ = 0.0;  ///< camera below the middle of the frame, for a deep dent [m]
};

}  // namespace asperity
