#pragma once

#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "ui/view/ContactShape.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/ViewFrame.h"

#include <QString>

#include <limits>
#include <optional>

class vtkRenderer;

namespace asperity {

struct Scene;

/// Values that a cross-hair reads at a position of the surface.
struct SurfaceReading {
    Vector3 position = Vector3::Zero();  ///< of the surface at rest, world [m]
    double pixel = 0.0;                  ///< of the scan; 0: positions are exact [m]
    QString quantity;                    ///< that the surface is colored by; empty: its height
    QString unit;                        ///< of the value
    double value = std::numeric_limits<double>::quiet_NaN();  ///< not a number: none there
};

/// "x 12.3 nm   y 40.1 nm   z 3.21 nm   slope 12 °": positions to a tenth of a pixel of the scan,
/// heights to 10 pm.
[[nodiscard]] QString textOf(const SurfaceReading& reading);

/// The line of sight through a pixel from the lower left corner, from the eye, world frame.
[[nodiscard]] SurfaceRay rayThrough(vtkRenderer& renderer, const Vector2& pixel,
                                    const DrawnSpace& space);

/// Position of the surface at rest whose present position a line of sight meets first [m]; none
/// where it meets no surface.
/// @param window  of the scan that is drawn
/// @param contact where the surface is deformed; null: nowhere
[[nodiscard]] std::optional<Vector2> seenPosition(const BSplineSurface& surface,
                                                  const SurfaceRay& ray, const ScanWindow& window,
                                                  const ContactShape* contact);

/// Reads the values at a position of the surface at rest; of heights, near the tip: displacement.
/// @param contact near the tip; null: there is none
[[nodiscard]] SurfaceReading readingAt(const Scene& scene, const SurfaceField& field,
                                       const ContactShape* contact, const Vector2& position);

}  // namespace asperity
