#pragma once

#include <array>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace asperity {

/// Adds `asperity explore`: the main job without a user, on a virtual clock.
void addExploreCommand(CLI::App& program);
/// Adds `asperity info`: what a height-map file holds, for people or as JSON.
void addInfoCommand(CLI::App& program);
/// Adds `asperity convert`: height maps of any readable files into another format.
void addConvertCommand(CLI::App& program);
/// Adds `asperity measure`: roughness, profile, angle and step height of a height map.
void addMeasureCommand(CLI::App& program);
/// Adds `asperity contact`: force and contact for each case of a table.
void addContactCommand(CLI::App& program);
/// Adds `asperity curve`: approach and retract curves with snap-in and pull-off.
void addCurveCommand(CLI::App& program);
/// Adds `asperity map`: a force curve or a raster line at each position of a scan.
void addMapCommand(CLI::App& program);
/// Adds `asperity decouple`: lever signals to three-dimensional forces with their covariance.
void addDecoupleCommand(CLI::App& program);
/// `asperity project INPUT --points P.csv`: the closest point on the fitted surface for each row.
void addProjectCommand(CLI::App& program);
/// Adds `asperity tradeoff`: measured cost and error of every model option.
void addTradeOffCommand(CLI::App& program);
/// Adds `asperity extremes`: where each contact law, solver and the whole tick is exact, valid,
/// flagged or refused, over the whole range of tips, samples and levers.
void addExtremesCommand(CLI::App& program);
/// Adds `asperity experiment`: a positioning study by the operator model.
void addExperimentCommand(CLI::App& program);
/// Adds `asperity replay`: runs a recorded input again and compares every force.
void addReplayCommand(CLI::App& program);
/// Adds `asperity render`: draws a scene, or a moment of a run, as a picture, a plot, or a field.
void addRenderCommand(CLI::App& program);
/// Adds `asperity film`: draws a run as a film.
void addFilmCommand(CLI::App& program);
/// Adds `asperity bundle`: a run with its scan and a picture in one file.
void addBundleCommand(CLI::App& program);
/// Adds `asperity report`: a page of recorded runs each, as HTML and as PDF.
void addReportCommand(CLI::App& program);
/// Adds `asperity compare`: by how much the normal force of a run differs from that of another.
void addCompareCommand(CLI::App& program);
/// Adds `asperity fit`: what measured force curves say of sample and lever, simulated beside them.
void addFitCommand(CLI::App& program);
/// Adds `asperity loop`: the real-time loop in wall time beside a bare loop in the same run.
void addLoopCommand(CLI::App& program);
/// Adds `asperity bench`: all measurements of speed with their goals, beside other programs.
void addBenchCommand(CLI::App& program);
/// Adds `asperity devices`: lists the input devices here and what each can do, for people or as
/// JSON.
void addDevicesCommand(CLI::App& program);

/// The subcommands, in the order in which the help lists them.
inline constexpr auto kCommands = std::to_array<void (*)(CLI::App& program)>({
    addExploreCommand,    addInfoCommand,    addConvertCommand,  addMeasureCommand,
    addContactCommand,    addCurveCommand,   addFitCommand,      addMapCommand,
    addDecoupleCommand,   addProjectCommand, addTradeOffCommand, addExtremesCommand,
    addExperimentCommand, addReplayCommand,  addRenderCommand,   addFilmCommand,
    addBundleCommand,     addReportCommand,  addCompareCommand,  addLoopCommand,
    addBenchCommand,      addDevicesCommand,
});

}  // namespace asperity
