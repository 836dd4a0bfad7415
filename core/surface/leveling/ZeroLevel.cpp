#include "core/surface/leveling/ZeroLevel.h"

#include "core/surface/leveling/CountedPixels.h"
#include "core/surface/leveling/PlaneFit.h"

#include <algorithm>

namespace asperity {

template <class Heights>
double lowestHeight(const BasicHeightMap<Heights>& map, Progress* progress) {
    requireUsable(map);
    const double first = firstHeight(map);
    return std::ranges::min(ofEachRow(map.rows, progress, [&](int row) {
        double lowest = first;
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                lowest = std::min(lowest, map.at(row, column));
            }
        }
        return lowest;
    }));
}

template double lowestHeight(const BasicHeightMap<std::vector<double>>&, Progress*);
template double lowestHeight(const BasicHeightMap<PixelVector<float>>&, Progress*);

}  // namespace asperity
