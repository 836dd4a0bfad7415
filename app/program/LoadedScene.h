#pragma once

#include "core/Progress.h"
#include "core/fidelity/SceneNeeds.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/probe/AfmController.h"
#include "core/scene/Scene.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What the command line may change about a scene before it is built; empty: as the scene says.
struct SceneOverrides {
    std::string channel;
    std::optional<LevelingSteps> leveling;
    std::optional<LevelPoints> levelPoints = {};  ///< of the step three_point
    std::optional<double> smoothingPixels;        ///< [pixel]
    std::optional<double> setpoint;               ///< of an approach [N]
    GivenScale scale = {};                        ///< of a file that does not say its own
    std::optional<PixelRectangle> crop = {};      ///< the part of the map that is loaded
};

/// What a map is loaded by: as the scene says, but for the overrides.
[[nodiscard]] SampleDescription withOverrides(SampleDescription sample,
                                              const SceneOverrides& overrides);

/// A scene with what is known of the file that it stands on.
struct LoadedScene {
    Scene scene;
    std::string format;              ///< of the height map, for people; "shape" without one
    std::string sha256;              ///< of the height map's file; empty without one
    std::vector<std::string> notes;  ///< on the heights, a sentence each: of reader and leveling
    std::vector<Provenance> provenance;    ///< what scale and orientation of the heights come from
    SceneNeeds needs;                      ///< why the scene's model is what it is
    std::vector<std::string> images = {};  ///< of the file, others with the scan's pixels
    std::vector<std::string> channels = {};  ///< of the file, those that can be taken instead
    std::size_t filledPixels = 0;            ///< of the map as loaded that held no data
};

/// All that was decided about a scene: its notes, and those on the force.
[[nodiscard]] std::vector<std::string> notesOn(const LoadedScene& loaded);

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

/// A copy of the same scan under another tip, lever, material or model, fitted anew now or later.
/// Reads nothing of the scene's description: that may change meanwhile.
/// @throw Error as withDescription(); Canceled
[[nodiscard]] LoadedScene withDescription(const LoadedScene& loaded,
                                          const SceneDescription& description,
                                          Progress* progress = nullptr,
                                          ModelFit fit = ModelFit::Now);

/// The instrument of a scene, which outlives it, in the window and in `explore`: a simulated AFM
/// that answers at once, as the scene's [truth] says.
[[nodiscard]] std::unique_ptr<AfmController> instrumentOf(const Scene& scene);

}  // namespace asperity
