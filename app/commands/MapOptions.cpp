#include "app/commands/MapOptions.h"

#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/SetpointOption.h"
#include "core/io/TextValue.h"

#include <limits>
#include <vector>

namespace asperity {

namespace {

CLI::Validator gridText() {
    return {[](const std::string& text) {
                return parseGrid(text)
                           ? std::string()
                           : "expected WIDTHxHEIGHT in pixels, such as 128x128, not '" + text + "'";
            },
            "WxH"};
}

CLI::Validator meters() {
    return {[](const std::string& text) {
                const std::optional<double> number = parseNumber(text);
                return number && std::isfinite(*number)
                           ? std::string()
                           : "expected x0,y0,x1,y1 in meters, such as 0,0,1e-7,1e-7, not '" + text +
                                 "'";
            },
            ""};
}

CLI::Validator gwyName() {
    return {[](const std::string& text) {
                return lowerCase(std::filesystem::path(text).extension().string()) == ".gwy"
                           ? std::string()
                           : "expected the name of a .gwy file, not '" + text + "'";
            },
            ""};
}

CLI::Validator modeName() {
    std::vector<std::string> keys;
    keys.reserve(kValues<MapMode>.size());
    for (const MapMode mode : kValues<MapMode>) {
        keys.emplace_back(keyOf(mode));
    }
    return CLI::IsMember(keys);
}

void addRequest(CLI::App& command, MapRequest& request) {
    command
        .add_option_function<std::string>(
            "--grid", [&request](const std::string& text) { request.grid = parseGrid(text); },
            "pixels of the map; default: those of the scan in the region")
        ->check(gridText());
    command
        .add_option_function<std::vector<double>>(
            "--region",
            [&request](const std::vector<double>& corners) {
                request.region = MapRegion{corners[0], corners[1], corners[2], corners[3]};
            },
            "part of the scan between the corners x0,y0 and x1,y1, from its lower left corner [m]; "
            "default: all of it")
        ->delimiter(',')
        ->expected(4)
        ->check(meters());
    addSetpointOption(command, request.setpoint);
    command
        .add_option_function<std::string>(
            "--mode",
            [&request](const std::string& key) {
                request.mode = fromKey<MapMode>(key).value_or(MapMode::Approach);
            },
            "approach: approach and retract at each pixel (default); contact: a raster at constant "
            "force, trace and retrace")
        ->check(modeName());
    command
        .add_option("--quantities", request.quantities,
                    "channels, separated by commas (docs/maps.md); default: all of the mode but "
                    "deviations")
        ->delimiter(',');
    command.add_flag(
        "--uncertainty", request.deviations,
        "standard deviations of adhesion, work, indentation and stiffness by model and "
        "calibration, too (docs/uncertainty.md)");
    command.add_flag("--truth", request.truth,
                     "map the simulated true instrument, section [truth] of the scene, in place of "
                     "the model");
}

void addCompare(CLI::App& command, MapOptions& options) {
    CLI::Option* const channel =
        command
            .add_option("--channel", options.channels,
                        "channel of the height-map file SCENE; default: as in the scene. With "
                        "--compare: channel of that file, as NAME or NAME:QUANTITY, once for each")
            ->allow_extra_args(false);
    command
        .add_option("--compare", options.compare,
                    "measured maps of the same area, in any format of height maps; writes "
                    "difference, correlation and the share of variance that the prediction "
                    "explains of each --channel")
        ->needs(channel)
        ->check(notEmpty());
}

}  // namespace

std::optional<MapGrid> parseGrid(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) {
        return std::nullopt;
    }
    const auto columns = parseInteger(text.substr(0, cross));
    const auto rows = parseInteger(text.substr(cross + 1));
    constexpr long long kMost = std::numeric_limits<int>::max();
    if (!columns || !rows || *columns < 0 || *rows < 0 || *columns > kMost || *rows > kMost) {
        return std::nullopt;
    }
    return MapGrid{static_cast<int>(*columns), static_cast<int>(*rows)};
}

void addMapOptions(CLI::App& command, MapOptions& options) {
    command.add_option("SCENE", options.scene, "scene.toml or a height-map file")
        ->required()
        ->check(notEmpty());
    command
        .add_option("--out", options.out,
                    "map to write (.gwy); .vti, .exr and pictures (.png) go beside it")
        ->required()
        ->check(gwyName());
    addRequest(command, options.request);
    addCompare(command, options);
    command
        .add_option("--threads", options.threads, "threads; default: as many as there are cores")
        ->check(CLI::Range(1, 1024));
    CLI::Option* const resume =
        command.add_flag("--resume", options.resume,
                         "go on with a map that was ended: its finished rows are in OUT.gwy.part");
    command
        .add_flag("--force", options.force,
                  "replace files of these names, and begin an unfinished map anew")
        ->excludes(resume);
    command.add_flag("--no-pictures", options.noPictures,
                     "draw no sheets of pictures: no display is needed");
}

}  // namespace asperity
