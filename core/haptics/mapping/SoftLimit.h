#pragma once

#include "core/Vector.h"

#include <cmath>

namespace asperity {

/// Length of a vector, where Eigen's norm() would overflow, too.
[[nodiscard]] inline double lengthOf(const Vector3& vector) noexcept {
    return std::hypot(vector.x(), vector.y(), vector.z());
}

/// The force f / sqrt(1 + |f|^2 / limit^2): its direction is that of f, small forces pass nearly
/// unchanged, none is above the limit. It is the gradient of a convex function of f, which is what
/// keeps a spring with a damper passive when their sum is limited; docs/haptics.md.
/// @param force finite [N]
/// @param limit >= 0 [N]; 0: no force
[[nodiscard]] inline Vector3 softLimited(const Vector3& force, double limit) noexcept {
    const double size = lengthOf(force);
    if (!(size > 0.0 && limit > 0.0)) {
        return Vector3::Zero();
    }
    // Of the two forms, that whose quotient is at most 1.
    return size > limit ? Vector3((force / size) * (limit / std::hypot(1.0, limit / size)))
                        : Vector3(force / std::hypot(1.0, size / limit));
}

}  // namespace asperity
