#pragma once

#include "core/haptics/VirtualRun.h"
#include "vtkplugins/pictures/DeformationPicture.h"

#include <string>

namespace asperity {

struct Scene;

/// The patch around the tip that pictures of a moment show: as wide as the scene says, or else as
/// the surface that visibly follows the tip.
[[nodiscard]] PatchGrid zoomGrid(const Scene& scene, const TickSample& sample);

/// The deformed surface that these pictures show; files hold the same.
[[nodiscard]] SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample);

/// The same of another patch.
[[nodiscard]] SurfacePatch zoomPatch(const Scene& scene, const TickSample& sample,
                                     const PatchGrid& grid);

/// A moment of a run as the deformation picture shows it, deformed as the scene says.
[[nodiscard]] DeformationView contactView(const Scene& scene, const TickSample& sample,
                                          const std::string& title);
/// The same of another patch.
[[nodiscard]] DeformationView contactView(const Scene& scene, const TickSample& sample,
                                          const std::string& title, const PatchGrid& grid);

}  // namespace asperity
