#pragma once

#include "core/Vector.h"

#include <QString>

#include <limits>

namespace asperity {

/// What a cross-hair reads at a place of the surface.
struct SurfaceReading {
    Vector3 place = Vector3::Zero();  ///< of the surface at rest, world [m]
    QString quantity;                 ///< that the surface is colored by; empty: its height
    QString unit;                     ///< of the value
    double value = std::numeric_limits<double>::quiet_NaN();  ///< not a number: none there
};

/// "x 12.34 nm   y 40.12 nm   z 3.21 nm   slope 12 °"
[[nodiscard]] QString textOf(const SurfaceReading& reading);

}  // namespace asperity
