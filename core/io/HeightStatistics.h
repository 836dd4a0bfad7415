#pragma once

#include "core/surface/HeightMap.h"

#include <cstddef>

namespace asperity {

/// Statistics of the pixels that hold data; NaN when none does. In the unit of the values.
struct HeightStatistics {
    double lowest = 0.0;
    double highest = 0.0;
    double mean = 0.0;
    double rms = 0.0;  ///< root mean square about the mean (population)
    std::size_t invalidPixels = 0;
};

[[nodiscard]] HeightStatistics heightStatistics(const HeightMap& map);

}  // namespace asperity
