#pragma once

#include "app/program/LoadedScene.h"
#include "core/map/MapPlan.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace asperity {

/// What a user asks `asperity map` for.
struct MapOptions {
    std::string scene;
    std::string out;
    MapRequest request;
    SceneOverrides overrides;
    int threads = 0;  ///< 0: as many as the machine has cores
    bool resume = false;
    bool force = false;
    bool noPictures = false;
};

/// "512x256" as columns and rows; empty where it is anything else.
[[nodiscard]] std::optional<MapGrid> parseGrid(const std::string& text);

/// The options that make them up. @param options outlive the parse
void addMapOptions(CLI::App& command, MapOptions& options);

}  // namespace asperity
