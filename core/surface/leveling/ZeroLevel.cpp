#include "core/surface/leveling/ZeroLevel.h"

#include "core/surface/leveling/CountedPixels.h"
#include "core/surface/leveling/PlaneFit.h"

#include <algorithm>

namespace asperity {

template <class Heights>
double lowestHeight(const BasicHeightMap<Heights>& map) {
    requireUsable(map);
    double lowest = firstHeight(map);
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                lowest = std::min(lowest, map.at(row, column));
            }
        }
    }
    return lowest;
}

template double lowestHeight(const BasicHeightMap<std::vector<double>>&);
template double lowestHeight(const BasicHeightMap<PixelVector<float>>&);

}  // namespace asperity
