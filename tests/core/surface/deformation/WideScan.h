#pragma once

#include "core/Units.h"
#include "core/surface/HeightMap.h"

namespace asperity::test {

/// The edge of a scan much wider than the tip [m].
inline constexpr double kWideSize = 200.0_nm;
inline constexpr ScanSize kWideScan{
    .columns = 100, .rows = 80, .sizeX = kWideSize, .sizeY = kWideSize};

}  // namespace asperity::test
