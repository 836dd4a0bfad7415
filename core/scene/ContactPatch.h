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

}  // namespace asperity
