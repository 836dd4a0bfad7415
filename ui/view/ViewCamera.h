#pragma once

#include "core/Vector.h"

#include <cstdint>

class vtkCamera;

namespace asperity {

/// What a view is to show: a square frame, from the bottom of the block to the tip.
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

/// Where the eye of a view is: it looks at the middle of a frame from any side, turned by hand
/// always from above the surface; without perspective, so that lengths across the view are to
/// scale, or with it.
class ViewCamera {
public:
    /// Turns about the vertical and over the surface [rad].
    void turn(double azimuth, double elevation);
    /// Looks along an axis of the scan.
    void lookFrom(ViewDirection side);
    /// Of the eye, from x and above the horizontal [rad].
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
    /// How long a height of 1 looks, 0 .. 1: none is seen from above.
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

}  // namespace asperity
