#pragma once

#include "core/surface/SurfaceRay.h"
#include "ui/view/ContactShape.h"
#include "ui/view/DrawnSpace.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/SurfaceReading.h"

#include <optional>

class vtkRenderer;

namespace asperity {

struct Scene;

/// The line of sight through a pixel from the lower left corner, from the eye, world frame.
[[nodiscard]] SurfaceRay rayThrough(vtkRenderer& renderer, const Vector2& pixel,
                                    const DrawnSpace& space);

/// The place of the surface at rest whose present place a line of sight meets first [m]; none where
/// it meets no surface.
/// @param window  of the scan that is drawn
/// @param contact where the surface is deformed; null: nowhere
[[nodiscard]] std::optional<Vector2> seenPlace(const BSplineSurface& surface, const SurfaceRay& ray,
                                               const ScanWindow& window,
                                               const ContactShape* contact);

/// What there is to read at a place of the surface at rest: of heights, near the tip, the
/// displacement.
/// @param contact near the tip; null: there is none
[[nodiscard]] SurfaceReading readingAt(const Scene& scene, const SurfaceField& field,
                                       const ContactShape* contact, const Vector2& place);

}  // namespace asperity
