#pragma once

#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "core/surface/SurfaceDeformation.h"

namespace asperity {

/// The surface around the contact as the believed contact model deforms it. The closed form shows
/// the sample's share of the displacement; the tip takes the rest. Off the tick: allocates.
/// @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch contactPatch(const Scene& scene, const TipState& state,
                                        DeformationTier tier, const PatchGrid& grid);

/// The same with the sharp rim of a wide contact as a picture shows it, see rimRounding().
[[nodiscard]] SurfacePatch drawnPatch(const Scene& scene, const TipState& state,
                                      DeformationTier tier, const PatchGrid& grid);

/// Where the foot lies once the surface has moved, world [m].
[[nodiscard]] Vector3 displacedFoot(const Scene& scene, const TipState& state,
                                    DeformationTier tier);

/// The tip's share of the displacement: its surface moves by so much into the tip, at a distance
/// from the contact's axis [m -> m]. Zero but for the closed form: the other tiers move the sample
/// alone.
[[nodiscard]] RadialDisplacement tipDisplacement(const Scene& scene, const TipState& state,
                                                 DeformationTier tier);

}  // namespace asperity
