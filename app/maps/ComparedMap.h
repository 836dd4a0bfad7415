#pragma once

#include "app/maps/MapPart.h"
#include "app/maps/MeasuredChannel.h"
#include "core/map/MapComparison.h"

#include <functional>
#include <string>
#include <vector>

namespace asperity {

/// Writes a row of a map, 0 at the top; NaN: no data.
using RowReader = std::function<void(int row, double* values)>;

/// A measured channel against the quantity of a map that it is compared with.
struct ComparedMap {
    std::string channel;  ///< name of the measured one
    MapQuantity quantity = MapQuantity::Height;
    MapGrid grid;           ///< of the measured channel
    std::size_t place = 0;  ///< of the quantity in the plan
    int number = 1;         ///< among those that are compared with the same quantity
    ComparedQuantity values;
};

/// Compares measured channels with what a part holds. Rows that it lacks hold no data.
[[nodiscard]] std::vector<ComparedMap> comparedMaps(std::vector<MeasuredChannel> channels,
                                                    const MapPlan& plan, const MapPart& part);

/// A map that a comparison gives, in the quantity's unit.
struct ComparisonLayer {
    std::string key;   ///< "adhesion_force_difference"
    std::string name;  ///< "adhesion force, 'Adhesion' minus predicted"
    RowReader readRow;
};
/// The difference, and the residual of the line. They need the arguments.
[[nodiscard]] std::vector<ComparisonLayer> layersOf(const ComparedMap& compared,
                                                    const MapPart& part);

}  // namespace asperity
