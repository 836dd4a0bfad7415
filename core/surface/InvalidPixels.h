#pragma once

#include "core/surface/HeightMap.h"

namespace asperity {

/// The map with a height in every pixel: those that held none get a blend of their surroundings,
/// grown inward from the rim of each hole, and are marked in the mask. Linear time.
///
/// A pixel holds no height when its value is not a finite number. A pixel that is marked invalid
/// but holds a finite height (filled before, or masked by the user) keeps both.
/// @throw Error when the map is unusable or no pixel holds a height
[[nodiscard]] HeightMap withInvalidPixelsFilled(HeightMap map);
[[nodiscard]] ScanMap withInvalidPixelsFilled(ScanMap map);

}  // namespace asperity
