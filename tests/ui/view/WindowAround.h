#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/OverviewPicture.h"

namespace asperity::test {

/// The square part of a scan within `reach` of a position along x and y [m].
[[nodiscard]] inline ScanWindow windowAround(const Vector3& position, double reach) {
    return {.left = position.x() - reach,
            .right = position.x() + reach,
            .bottom = position.y() - reach,
            .top = position.y() + reach};
}

}  // namespace asperity::test
