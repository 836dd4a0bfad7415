#pragma once

#include "app/program/LoadedScene.h"
#include "core/Progress.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/scene/SceneDescription.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"
#include "core/surface/PixelField.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

/// Overrides of a scene from the command line; an empty one keeps the value of the scene.
struct SceneOverrides {
    std::string channel;
    std::optional<LevelingSteps> leveling;
    std::optional<LevelPoints> levelPoints = {};  ///< of the step three_point
    std::optional<double> smoothingPixels;        ///< [pixel]
    std::optional<double> setpoint;               ///< of an approach [N]
    GivenScale scale = {};                        ///< of a file that does not say its own
    std::optional<PixelRectangle> crop = {};      ///< the part of the map that is loaded
    /// Scene whose material, tip, lever and model a height map gets; none: the defaults.
    std::optional<SceneDescription> like = {};
};

/// Returns the description of a sample with the overrides applied.
[[nodiscard]] SampleDescription withOverrides(SampleDescription sample,
                                              const SceneOverrides& overrides);

/// Time at which the terms are found that a scene needs. Until then its model has all of them.
enum class ModelFit : std::uint8_t { Now, Later };

/// Loads a scene file or a height map, fits the surface, sets up the instrument.
/// @throw InputError when anything it needs cannot be read or is out of range; Canceled
[[nodiscard]] LoadedScene loadScene(const std::filesystem::path& input,
                                    const SceneOverrides& overrides, Progress* progress = nullptr,
                                    ModelFit fit = ModelFit::Now);

/// The scene that a description asks for, whose file or shape it names. @throw as above
[[nodiscard]] LoadedScene loadScene(const SceneDescription& description,
                                    Progress* progress = nullptr);

/// Returns the scene on the same scan with another tip, lever, material or model; the terms of the
/// model are found now or later.
/// Reads nothing of the scene's description: that may change while it loads.
/// @throw Error as withDescription(); Canceled
[[nodiscard]] LoadedScene withDescription(const LoadedScene& loaded,
                                          const SceneDescription& description,
                                          Progress* progress = nullptr,
                                          ModelFit fit = ModelFit::Now);

/// Names of the images of a file that have the pixels of its channel of this name, each once; that
/// one left out.
[[nodiscard]] std::vector<std::string> imagesBeside(const HeightMapFile& file,
                                                    const std::string& channel);

/// The image of this name in the file of a sample, over the pixels of its surface, in the file's
/// unit. @throw InputError when it cannot be read or has other pixels; Canceled
[[nodiscard]] PixelField imageBeside(const SampleDescription& sample, const BSplineSurface& surface,
                                     const std::string& name, Progress* progress = nullptr);

/// Returns the heights of a scan, or of the part of it that is loaded, leveled as the sample says
/// and not smoothed. @throw InputError when the file cannot be read; Canceled
[[nodiscard]] std::variant<HeightMap, ScanMap> leveledScan(const SampleDescription& sample,
                                                           Progress* progress = nullptr);

/// Returns the residual, data minus surface, of a scan leveled as the sample says [m].
/// @param surface of this sample
/// @throw InputError when the file cannot be read, Error when the surface has another size;
/// Canceled
[[nodiscard]] PixelField residualImage(const SampleDescription& sample,
                                       const BSplineSurface& surface, Progress* progress = nullptr);

}  // namespace asperity
