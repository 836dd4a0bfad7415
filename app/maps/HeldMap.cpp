#include "app/maps/HeldMap.h"

#include "app/maps/MapKey.h"

#include <algorithm>
#include <utility>

namespace asperity {

HeldMap::HeldMap(LoadedScene loaded, const MapPlan& plan)
    : loaded_(std::move(loaded))
    , plan_(plan)
    , part_(folder_.path() / "map.part", plan_, mapKey(loaded_, plan_), PartUse::New) {}

RegionField HeldMap::field(MapQuantity quantity) const {
    const auto place = static_cast<std::size_t>(std::ranges::find(plan_.quantities, quantity) -
                                                plan_.quantities.begin());
    std::vector<double> row(static_cast<std::size_t>(plan_.grid.columns));
    std::vector<float> values;
    values.reserve(row.size() * static_cast<std::size_t>(plan_.grid.rows));
    for (int i = 0; i < plan_.grid.rows; ++i) {
        part_.read(i, place, row.data());
        std::ranges::transform(row, std::back_inserter(values),
                               [](double value) { return static_cast<float>(value); });
    }
    const MapRegion& region = plan_.region;
    return {{region.left, region.bottom, region.right - region.left, region.top - region.bottom},
            plan_.grid.columns,
            plan_.grid.rows,
            std::move(values),
            rowOf(quantity)->unit};
}

MapValues HeldMap::valuesAt(int row, int column) const {
    std::vector<double> line(static_cast<std::size_t>(plan_.grid.columns));
    MapValues values;
    for (std::size_t i = 0; i < plan_.quantities.size(); ++i) {
        part_.read(row, i, line.data());
        values[plan_.quantities[i]] = line.at(static_cast<std::size_t>(column));
    }
    return values;
}

}  // namespace asperity
