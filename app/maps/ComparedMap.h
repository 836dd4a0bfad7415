#pragma once

#include "app/maps/MapPart.h"
#include "core/map/MapComparison.h"
#include "core/map/MapPlan.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

class Progress;

/// A channel of a measured file, to be compared with a quantity of a map.
struct MeasuredChannel {
    std::string name;
    MapQuantity quantity = MapQuantity::Height;
    MapGrid grid;                ///< its own pixels
    std::vector<double> values;  ///< at the centers of the map's pixels, in the quantity's unit
};

/// The channels of a measured file that a map is compared with.
struct MeasuredFile {
    std::string path;
    std::string sha256;
    std::vector<MeasuredChannel> channels;
    std::vector<std::string> notes;  ///< of the reader on them, a sentence each
};

/// Reads channels of a file in any format of height maps.
/// @param asked names of channels, each alone or with the key of the quantity that it is compared
/// with, "Adhesion:adhesion_force"; by itself a channel is compared with what its unit and title
/// say
/// @throw InputError where the file cannot be read, there is no such channel, it shows another area
/// than region and scan or does not say how large it is, its unit is another one, several
/// quantities come into question, or it holds no data at the map's pixels; Canceled
[[nodiscard]] MeasuredFile readMeasured(const std::filesystem::path& path,
                                        const std::vector<std::string>& asked, const Scene& scene,
                                        const MapPlan& plan, Progress* progress = nullptr);

/// Writes a row of a map, 0 at the top; NaN: no data.
using RowReader = std::function<void(int row, double* values)>;

/// A measured channel against the quantity of a map that it is compared with.
struct ComparedMap {
    std::string channel;  ///< name of the measured one
    MapQuantity quantity = MapQuantity::Height;
    MapGrid grid;           ///< of the measured channel
    std::size_t index = 0;  ///< of the quantity in the plan
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
