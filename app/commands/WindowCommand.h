#pragma once

#include "app/runs/RunFolder.h"
#include "core/surface/GivenScale.h"
#include "core/surface/HeightMap.h"
#include "core/surface/leveling/LevelingStep.h"

#include <memory>
#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Options of `asperity [FILE or SCENE.toml]`.
struct WindowOptions {
    std::string input;                      ///< empty: the scene that comes with the program
    std::string channel;                    ///< of the input's height map; empty: as the scene says
    GivenScale scale;                       ///< of a file that does not say its own
    std::optional<LevelingSteps> leveling;  ///< none: as the scene says
    std::optional<LevelPoints> levelPoints;  ///< of the step three_point
    std::optional<PixelRectangle> crop;      ///< the part of the map that is loaded
    std::string record;  ///< folder for a recording from the first tick on; empty: none
    RunFormat format = RunFormat::Csv;  ///< of the recording
    bool force = false;                 ///< an earlier run in that folder may be deleted
    bool timeStart = false;             ///< print how soon the window shows something, and end
};

/// Adds the options of the program itself, without a subcommand.
[[nodiscard]] std::shared_ptr<WindowOptions> addWindowOptions(CLI::App& program);

/// Opens the window and stays until it is closed. @return the program's exit status
/// @throw Error without a display, InputError when the input cannot be read
[[nodiscard]] int openWindow(const WindowOptions& options);

}  // namespace asperity
