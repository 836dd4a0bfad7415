#pragma once

#include "core/Vector.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <vector>

namespace asperity {

/// A patch at rest, between its samples. Its grid runs along x and y; beyond its border the
/// border's values go on.
class RestingPatch {
public:
    /// Keeps a copy of what it needs.
    explicit RestingPatch(const SurfacePatch& patch);

    /// A field with one vector a sample, at the position that rests at (x, y).
    [[nodiscard]] Vector3 at(const std::vector<Vector3>& field, double x, double y) const;
    /// Unit normal of the surface at rest; beyond the border that of the border.
    [[nodiscard]] Vector3 normal(double x, double y) const;
    /// Returns where the line through `point` along unit `direction` meets the surface at rest.
    [[nodiscard]] Vector3 closest(const Vector3& point, const Vector3& direction) const;

private:
    std::vector<double> x_;  ///< columns [m]
    std::vector<double> y_;  ///< rows [m]
    std::vector<Vector3> rest_;
};

/// Edge of a contact; world frame.
struct ContactEdge {
    Vector3 center = Vector3::Zero();    ///< on the contact's axis [m]
    Vector3 outward = Vector3::UnitZ();  ///< along the axis, out of the sample, unit
    double radius = 0.0;                 ///< about the axis, above zero [m]
};

/// The line in which the deformed surface meets the cylinder of a contact's radius about its axis,
/// world [m]. In pieces: it is broken where the surface is so steep that the line would run up or
/// down a wall instead of around the contact. A whole circle is one piece that ends where it began.
[[nodiscard]] std::vector<std::vector<Vector3>> contactCircle(const SurfacePatch& patch,
                                                              const ContactEdge& edge);

}  // namespace asperity
