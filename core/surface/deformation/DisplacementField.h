#pragma once

#include "core/surface/deformation/SurfaceDeformation.h"
#include "core/surface/deformation/SurfaceRefinement.h"

namespace asperity {

/// The four control points around the closest point move by the indentation against the normal.
[[nodiscard]] DisplacementField fourPointField(const BSplineSurface& surface,
                                               const TipContact& contact);

/// The control points within the contact radius of the contact's axis move along that axis onto the
/// tip: down where the tip indents the surface, up where it draws out a neck. Those at the rim move
/// part of the way, so that it is round.
[[nodiscard]] DisplacementField contactRadiusField(const BSplineSurface& surface,
                                                   const TipContact& contact);

/// Every point moves by displacement(distance from the contact's axis) against the normal.
[[nodiscard]] DisplacementField closedFormField(const TipContact& contact,
                                                RadialDisplacement displacement);

/// What a model moves the surface by; see deformedPatch().
/// @throw Error where ClosedForm or HalfSpace is given no displacement
[[nodiscard]] DisplacementField displacementField(const BSplineSurface& surface,
                                                  const TipContact& contact, DeformationModel model,
                                                  const RadialDisplacement& displacement);

/// The surface around the contact, refined to `spacing` along its slope, and wide enough that
/// control points within the contact radius or beside the closest point shape no point at its edge.
[[nodiscard]] SplinePatch netAroundContact(const BSplineSurface& surface, const TipContact& contact,
                                           double spacing);

/// What a net moves the surface by when its control points hold displacements.
[[nodiscard]] DisplacementField fieldOf(SplinePatch displacements);

/// Distance of a point from the contact's axis [m].
[[nodiscard]] double distanceFromAxis(const TipContact& contact, const Vector3& point);

}  // namespace asperity
