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

    /// A field with one vector a sample, at the place that rests at (x, y).
    [[nodiscard]] Vector3 at(const std::vector<Vector3>& field, double x, double y) const;
    /// Unit normal of the surface at rest; beyond the border that of the border.
    [[nodiscard]] Vector3 normal(double x, double y) const;
    /// Where the line through `point` along the unit vector `direction` meets the surface at rest.
    [[nodiscard]] Vector3 closest(const Vector3& point, const Vector3& direction) const;

private:
    std::vector<double> x_;  ///< columns [m]
    std::vector<double> y_;  ///< rows [m]
    std::vector<Vector3> rest_;
};

}  // namespace asperity
