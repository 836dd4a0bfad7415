#pragma once

#include "core/surface/HeightMap.h"

#include <span>
#include <vector>

namespace asperity {

/// Times of the surfaces of several maps [s].
struct FitTimes {
    std::vector<double> fit;      ///< smoothing and spline
    std::vector<double> surface;  ///< these and the bounds of the surface, which searches use
};

/// Best of several rounds; the maps take turns, so that all meet the same machine.
[[nodiscard]] FitTimes timeFits(std::span<const ScanMap> maps);

}  // namespace asperity
