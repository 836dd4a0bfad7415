#pragma once

#include "core/Progress.h"
#include "core/scene/Scene.h"
#include "core/surface/HeightMap.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The scan that the maps of a sample's material lie over.
struct MapArea {
    int columns = 0;  ///< of the whole scan [pixel]
    int rows = 0;
    double pitchX = 0.0;  ///< [m]
    double pitchY = 0.0;  ///< [m]
    PixelRectangle part;  ///< that is loaded
};

/// The area of a scan, of which a part is loaded or all. @param map its heights may be missing
template <class Map>
[[nodiscard]] MapArea mapArea(const Map& map, const std::optional<PixelRectangle>& part = {}) {
    return {.columns = map.columns,
            .rows = map.rows,
            .pitchX = map.pitchX,
            .pitchY = map.pitchY,
            .part = part.value_or(PixelRectangle{0, 0, map.columns, map.rows})};
}

/// The area of a shape. @param size of its window [m]
[[nodiscard]] inline MapArea shapeArea(double size) {
    return {.columns = 1, .rows = 1, .pitchX = size, .pitchY = size, .part = {0, 0, 1, 1}};
}

/// Reads the maps that both materials of a description name, and writes into it what they turn out
/// to be: absolute paths, channels, hashes. Pixels without data get a blend of their surroundings.
///
/// A map covers the whole scan or the part that is loaded, with any number of pixels; one of the
/// whole scan has the scan's pixels where only a part is loaded. A file that gives no lateral size
/// covers what its pixels fit.
/// @throw InputError where a file cannot be read or is not the one that the description has the
/// hash of, a channel is not there or has another unit, a map has another size, or a value is
/// outside the range that a scene may have; Canceled
/// @param notes gets a sentence on each map with pixels without data; may be null
[[nodiscard]] SceneMaps readSceneMaps(SceneDescription& description, const MapArea& area,
                                      Progress* progress = nullptr,
                                      std::vector<std::string>* notes = nullptr);

}  // namespace asperity
