#pragma once

#include "core/surface/HeightMap.h"

namespace asperity::test {

/// A bumpy map with irregular heights of some tens of nanometers and pixels of 3 nm x 5 nm.
[[nodiscard]] HeightMap bumpyMap(int columns, int rows);

/// The same with two pixels (first and fifth) that hold no data.
[[nodiscard]] HeightMap bumpyMapWithHoles(int columns, int rows);

}  // namespace asperity::test
