#pragma once

#include "core/probe/TipEquilibrium.h"
#include "core/scene/HalfSpaceModel.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/SurfaceDeformation.h"

namespace asperity {

/// Tip and surface at a state, as they are drawn.
[[nodiscard]] TipContact tipContact(const Scene& scene, const TipState& state);

/// The surface around the contact as the believed contact model deforms it. The closed form shows
/// the sample's share of the displacement; the tip takes the rest. So does the half-space, which is
/// solved afresh; where it is not valid the closed form stands in. Off the tick: allocates.
/// @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch contactPatch(const Scene& scene, const TipState& state,
                                        DeformationTier tier, const PatchGrid& grid);

/// The surface as a valid answer of the half-space has it. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                                          const PatchGrid& grid);

/// The same with the sharp rim of a wide contact as a picture shows it, see rimRounding().
[[nodiscard]] SurfacePatch drawnPatch(const Scene& scene, const TipState& state,
                                      DeformationTier tier, const PatchGrid& grid);

/// Where the foot lies once the surface has moved, world [m].
[[nodiscard]] Vector3 displacedFoot(const Scene& scene, const TipState& state,
                                    DeformationTier tier);

/// The tip's share of the displacement: its surface moves by so much into the tip, at a distance
/// from the contact's axis [m -> m], by the closed form. Zero for tiers that move the sample alone.
[[nodiscard]] RadialDisplacement tipDisplacement(const Scene& scene, const TipState& state,
                                                 DeformationTier tier);

}  // namespace asperity
