#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/OverviewPicture.h"

namespace asperity::test {

/// The square part of a scan within `reach` of a place along x and y [m].
[[nodiscard]] inline ScanWindow windowAround(const Vector3& place, double reach) {
    return {.left = place.x() - reach,
            .right = place.x() + reach,
            .bottom = place.y() - reach,
            .top = place.y() + reach};
}

}  // namespace asperity::test
