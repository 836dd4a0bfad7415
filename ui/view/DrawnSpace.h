#pragma once

#include "core/Vector.h"

#include <vtkActor.h>

namespace asperity {

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

}  // namespace asperity
