#pragma once

#include "core/io/heightmap/HeightStatistics.h"
#include "core/surface/HeightMap.h"

namespace asperity::test {

/// Statistics of a map whose pixels without data are NaN.
inline HeightStatistics statisticsOf(const HeightMap& map) {
    return heightStatistics([&map](const TakeRow& take) { take(map.heights); });
}

}  // namespace asperity::test
