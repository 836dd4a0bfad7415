#pragma once

#include "app/program/LoadedScene.h"
#include "core/Progress.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

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
};

/// Returns the description of a sample with the overrides applied.
[[nodiscard]] SampleDescription withOverrides(SampleDescription sample,
                                              const SceneOverrides& overrides);

/// When the terms are found that a scene requires of its model. Until then it has all of them.
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
/// Reads nothing of the scene's description: that may change meanwhile.
/// @throw Error as withDescription(); Canceled
[[nodiscard]] LoadedScene withDescription(const LoadedScene& loaded,
                                          const SceneDescription& description,
                                          Progress* progress = nullptr,
                                          ModelFit fit = ModelFit::Now);

}  // namespace asperity
