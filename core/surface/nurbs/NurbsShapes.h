#pragma once

#include "core/Vector.h"
#include "core/surface/nurbs/NurbsSurface.h"

namespace asperity {

/// Shapes whose rational representation is exact, as their outsides are touched.
/// Source: Piegl, Tiller: The NURBS Book (1997), chapter 8.

/// Right-handed axes in space for a shape of revolution: `axis` is first x second.
struct RevolutionFrame {
    Vector3 center = Vector3::Zero();   ///< [m]
    Vector3 first = Vector3::UnitX();   ///< unit; where u = 0 lies
    Vector3 second = Vector3::UnitY();  ///< unit; where u = 1/4 lies
    [[nodiscard]] Vector3 axis() const { return first.cross(second); }
};

/// A whole sphere; v goes from pole to pole along the frame's axis.
/// @throw Error as NurbsSurface(), or when the radius is not positive
[[nodiscard]] NurbsSurface sphereSurface(const RevolutionFrame& frame, double radius);

/// The mantle of a cylinder about the frame's axis, from -length/2 to length/2.
/// @throw Error as NurbsSurface(), or when a size is not positive
[[nodiscard]] NurbsSurface cylinderSurface(const RevolutionFrame& frame, double radius,
                                           double length);

/// A ring about the frame's axis. @param radius of the ring's middle line, > tubeRadius [m]
/// @throw Error as NurbsSurface(), or when a radius is not positive
[[nodiscard]] NurbsSurface torusSurface(const RevolutionFrame& frame, double radius,
                                        double tubeRadius);

/// The parallelogram from `corner` along the two sides; their cross product points out of the
/// sample. @throw Error as NurbsSurface(), or when the sides span no area
[[nodiscard]] NurbsSurface planeSurface(const Vector3& corner, const Vector3& sideU,
                                        const Vector3& sideV);

}  // namespace asperity
