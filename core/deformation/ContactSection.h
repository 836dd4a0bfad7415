#pragma once

#include "core/deformation/ContactDeformation.h"

#include <array>
#include <optional>
#include <vector>

namespace asperity {

struct Scene;

/// Where a section is made.
struct SectionPlane {
    double azimuth = 0.0;          ///< of the vertical plane through the tip's axis, from x [rad]
    double halfWidth = 0.0;        ///< seen on each side of the tip's axis [m]
    int samples = 401;             ///< along the surface, at least 2
    double tipHeight = 0.0;        ///< of the tip's outline above the apex [m]
    double paraboloidReach = 0.0;  ///< above 0: the tip is a paraboloid to here, else a sphere [m]
};

/// Tip and sample in a vertical plane through the tip's axis. Points are (along the plane from the
/// tip's axis, world z) [m]. The surface moves along the contact's normal: on a slope partly out of
/// the plane, and the section shows what lies in it before and after of the same points.
struct ContactSection {
    Vector2 axis = Vector2::Zero();        ///< of the tip, world x, y [m]
    Vector2 direction = Vector2::UnitX();  ///< of the plane, unit
    std::vector<Vector2> rest;             ///< the undeformed surface, as far as the scan reaches
    std::vector<Vector2> deformed;         ///< the same points as they have moved
    std::vector<Vector2> tip;              ///< outline of the deformed tip, from left to right
    std::optional<std::array<Vector2, 2>> rim;  ///< ends of the contact; none without contact
    Vector2 contact = Vector2::Zero();          ///< where the contact's axis meets the surface

    /// World place of a point along the plane, on no height [m].
    [[nodiscard]] Vector2 placeAt(double along) const { return axis + along * direction; }
};

/// @param deformation of this scene and state
[[nodiscard]] ContactSection contactSection(const Scene& scene,
                                            const ContactDeformation& deformation,
                                            const SectionPlane& plane);

}  // namespace asperity
