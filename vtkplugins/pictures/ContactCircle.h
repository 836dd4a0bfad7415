#pragma once

#include "core/Vector.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <vector>

namespace asperity {

/// Where a contact's edge lies; world frame.
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
