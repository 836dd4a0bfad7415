#pragma once

#include "core/Progress.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/scene/Scene.h"
#include "core/surface/Provenance.h"

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

/// A scene on the sample that its description names, with what the sample's file says.
struct SceneOnSample {
    Scene scene;
    std::unique_ptr<const ScanFile> file;  ///< of the heights, still open; null: they are a shape's
    std::string format;                    ///< of the file, for people; "shape" without one
    std::vector<std::string> notes;        ///< of the readers of all files, a sentence each
    std::vector<Provenance> provenance;    ///< sources of scale and orientation of the heights
    std::size_t filledPixels = 0;          ///< of the map as read that held no data
    double originX = 0.0;  ///< lower left corner of the scan in the instrument's frame [m]
    double originY = 0.0;  ///< its y [m]
};

/// Reads the sample of a description, with the maps of its materials and the curve of its
/// instrument, and builds the scene. Its description has the files as absolute paths, the channels
/// that were taken, and no part where all of the channel was.
/// @throw InputError when a file cannot be read or does not fit; Error as buildScene(); Canceled
[[nodiscard]] SceneOnSample sceneOnSample(SceneDescription description,
                                          Progress* progress = nullptr);

/// Builds the scene of a description on other heights than its own file's, all of them.
/// @throw Error when its sample is a shape; else as sceneOnSample()
[[nodiscard]] Scene sceneOnHeights(SceneDescription description,
                                   std::variant<HeightMap, ScanMap> heights,
                                   Progress* progress = nullptr);

}  // namespace asperity
