#pragma once

#include "core/Vector.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkPolyData;

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

/// Draws small distances from a resting surface larger: what lies a distance above it, measured
/// along one direction, is drawn at `factor` times that distance. Surface, tip and contact stay in
/// touch as they were.
class Stretch {
public:
    /// @param direction unit vector, out of the sample
    Stretch(const SurfacePatch& patch, Vector3 direction, double factor);

    [[nodiscard]] Vector3 point(const Vector3& point) const;
    /// The normal, at the stretched place, of a surface with this point and unit normal.
    [[nodiscard]] Vector3 normal(const Vector3& point, const Vector3& normal) const;
    /// A copy with stretched points and, where there are any, normals.
    [[nodiscard]] vtkSmartPointer<vtkPolyData> apply(vtkPolyData* data) const;

private:
    [[nodiscard]] Vector3 normalAbove(const Vector3& closest, const Vector3& normal) const;

    RestingPatch resting_;
    Vector3 direction_;
    double factor_;
};

/// `surface`, which has one point a sample of the patch in the same order, with the patch's
/// displacements drawn `factor` times as large. Exact however steep the patch is.
[[nodiscard]] vtkSmartPointer<vtkPolyData> stretchedSurface(const SurfacePatch& patch,
                                                            double factor, vtkPolyData* surface);

}  // namespace asperity
