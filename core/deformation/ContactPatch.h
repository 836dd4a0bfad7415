#pragma once

#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceAnswer.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/deformation/SurfaceDeformation.h"

namespace asperity {

struct Scene;

/// The surface around the contact as it is deformed. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch drawnPatch(const Scene& scene, const ContactDeformation& deformation,
                                      const PatchGrid& grid);

/// The same to full precision and with a sharp rim, as studies and tests compare it: each sample by
/// the contact law itself, the half-space solved afresh; where that is not valid the closed form
/// stands in. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch exactPatch(const Scene& scene, const TipState& state,
                                      DeformationModel model, const PatchGrid& grid);

/// The surface as a valid answer of the half-space has it. @throw Error as deformedPatch()
[[nodiscard]] SurfacePatch halfSpacePatch(const Scene& scene, const HalfSpaceAnswer& answer,
                                          const PatchGrid& grid);

/// Where the closest point lies once the surface has moved, world [m].
[[nodiscard]] Vector3 displacedPoint(const Scene& scene, const TipState& state,
                                     DeformationModel model);

}  // namespace asperity
