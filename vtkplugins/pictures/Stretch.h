#pragma once

#include "core/Vector.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace asperity {

/// The space that a picture draws: the world, with all heights multiplied by one factor. Surface,
/// tip and contact share it, so that what touches in the world touches in the picture.
class Stretch {
public:
    /// @param factor 1: true to scale
    explicit Stretch(double factor) : factor_(factor) {}

    [[nodiscard]] double factor() const { return factor_; }
    [[nodiscard]] Vector3 point(const Vector3& world) const {
        return {world.x(), world.y(), factor_ * world.z()};
    }
    /// Unit normal of what is drawn, of the unit normal of a surface in the world.
    [[nodiscard]] Vector3 normal(const Vector3& world) const {
        return Vector3(world.x(), world.y(), world.z() / factor_).normalized();
    }
    /// A copy with stretched points and, where there are any, normals.
    [[nodiscard]] vtkSmartPointer<vtkPolyData> apply(vtkPolyData* data) const;

private:
    double factor_;
};

}  // namespace asperity
