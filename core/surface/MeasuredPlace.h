#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// The place itself where the scan holds data, else the center of the nearest pixel that holds
/// some; the place, too, where no pixel does. World frame [m].
[[nodiscard]] Vector2 nearestMeasured(const BSplineSurface& surface, const Vector2& place);

}  // namespace asperity
