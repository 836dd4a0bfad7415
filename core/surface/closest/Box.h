#pragma once

#include "core/Vector.h"

namespace asperity {

/// The rectangle of places that may be searched, world [m].
struct Box {
    Vector2 low = Vector2::Zero();
    Vector2 high = Vector2::Zero();

    [[nodiscard]] Vector2 nearest(const Vector2& place) const {
        return place.cwiseMax(low).cwiseMin(high);
    }
    [[nodiscard]] bool holds(const Vector2& place) const { return place == nearest(place); }
};

}  // namespace asperity
