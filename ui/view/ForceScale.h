#pragma once

#include "core/Vector.h"

#include <string>

namespace asperity {

/// Length of a force's arrow: a larger force always has a longer one, and none is longer than its
/// room; far below `usual` the length is proportional to the force [m].
/// @param magnitude of the force, >= 0 [N]
/// @param usual     force whose arrow fills half of the room, > 0 [N]
/// @param room      [m]
[[nodiscard]] double arrowLength(double magnitude, double usual, double room);

/// Magnitude of a force for its arrow: "5.10 nN". @param force [N]
[[nodiscard]] std::string magnitudeText(const Vector3& force);

}  // namespace asperity
