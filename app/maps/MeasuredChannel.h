#pragma once

#include "core/map/MapPlan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

class Progress;

/// A channel of a measured file, on its way to be compared with a quantity of a map.
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

}  // namespace asperity
