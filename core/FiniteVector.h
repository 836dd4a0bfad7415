#pragma once

#include "core/Vector.h"

#include <cmath>

namespace asperity {

/// Whether both parts are numbers. Eigen's allFinite() subtracts, which raises the invalid flag.
[[nodiscard]] inline bool isFinite(const Vector2& vector) {
    return std::isfinite(vector.x()) && std::isfinite(vector.y());
}

}  // namespace asperity
