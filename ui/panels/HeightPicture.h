#pragma once

#include "core/surface/HeightMap.h"

#include <QImage>

namespace asperity {

/// A map seen from above, colored by height; gray stripes where it holds no data. The colors run
/// from the height that 0.5 % of the pixels lie below to the one that 0.5 % lie above, so that a
/// few outliers do not leave the rest in one color.
/// @return at most 512 pixels along either side, the map's top row at the top; any thread
[[nodiscard]] QImage heightPicture(const HeightMap& map);

}  // namespace asperity
