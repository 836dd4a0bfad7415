#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/deformation/DisplacementField.h"

#include <memory>
#include <vector>

namespace asperity {

/// Displacement of a half-space's surface around a contact, smooth between the pixels that it was
/// solved at; beyond them it falls off with the distance, as under a point force.
class HalfSpaceField {
public:
    /// @param displacement of samples x samples pixels, row-major, into the sample [m]
    HalfSpaceField(const std::vector<double>& displacement, int samples, double pitch);

    /// At a place in the tangent plane, from the contact's axis [m].
    [[nodiscard]] double at(double along, double across) const;

private:
    double halfWidth_;  ///< to the middle of the outermost pixels [m]
    double middle_;     ///< of the grid, from its corner [m]
    BSplineSurface displacement_;
};

/// Every point moves by its part `share` of the field against the normal of a contact, around its
/// closest point.
[[nodiscard]] DisplacementField halfSpaceField(const TipContact& contact,
                                               std::shared_ptr<const HalfSpaceField> field,
                                               double share);

}  // namespace asperity
