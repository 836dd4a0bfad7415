#pragma once

#include "core/map/MapPlan.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What a user asks `asperity map` for.
struct MapOptions {
    std::string scene;
    std::string out;
    MapRequest request;
    std::vector<std::string> channels;  ///< of the scan, or of the measured file if there is one
    std::string compare;                ///< measured file; empty: none
    int threads = 0;                    ///< 0: as many as the machine has cores
    bool resume = false;
    bool force = false;
    bool noPictures = false;
};

/// "512x256" as columns and rows; empty where it is anything else.
[[nodiscard]] std::optional<MapGrid> parseGrid(const std::string& text);

/// The options that make them up. @param options outlive the parse
void addMapOptions(CLI::App& command, MapOptions& options);

}  // namespace asperity
