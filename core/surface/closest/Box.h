#pragma once

#include "core/Vector.h"

namespace asperity {

/// The rectangle of positions that may be searched, world [m].
struct Box {
    Vector2 low = Vector2::Zero();
    Vector2 high = Vector2::Zero();

    [[nodiscard]] Vector2 nearest(const Vector2& point) const {
        return point.cwiseMax(low).cwiseMin(high);
    }
    [[nodiscard]] bool holds(const Vector2& point) const { return point == nearest(point); }
};

/// Row and column of a spline cell, see CellBounds.
struct CellIndex {
    int row = 0;
    int column = 0;
};

}  // namespace asperity
