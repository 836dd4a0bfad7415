#include "app/commands/BenchCommand.h"
#include "app/commands/BundleCommand.h"
#include "app/commands/CompareCommand.h"
#include "app/commands/ContactCommand.h"
#include "app/commands/ConvertCommand.h"
#include "app/commands/CurveCommand.h"
#include "app/commands/DecoupleCommand.h"
#include "app/commands/DevicesCommand.h"
#include "app/commands/ExperimentCommand.h"
#include "app/commands/ExploreCommand.h"
#include "app/commands/ExtremesCommand.h"
#include "app/commands/FilmCommand.h"
#include "app/commands/InfoCommand.h"
#include "app/commands/LoopCommand.h"
#include "app/commands/MapCommand.h"
#include "app/commands/MeasureCommand.h"
#include "app/commands/ProjectCommand.h"
#include "app/commands/RenderCommand.h"
#include "app/commands/ReplayCommand.h"
#include "app/commands/ReportCommand.h"
#include "app/commands/TradeOffCommand.h"
#include "app/commands/WindowCommand.h"
#include "app/program/StandardStreams.h"
#include "app/program/ToldError.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/Version.h"
#include "vtkplugins/pictures/VtkMessages.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <sstream>

namespace {

int run(int argc, char** argv) {
    CLI::App program("Asperity: an augmented-reality interface for an atomic force microscope");
    program.set_version_flag("--version", std::string("asperity ") + asperity::kVersion);
    program.require_subcommand(0, 1);
    const auto window = asperity::addWindowOptions(program);
    asperity::addExploreCommand(program);
    asperity::addInfoCommand(program);
    asperity::addConvertCommand(program);
    asperity::addMeasureCommand(program);
    asperity::addContactCommand(program);
    asperity::addCurveCommand(program);
    asperity::addMapCommand(program);
    asperity::addDecoupleCommand(program);
    asperity::addProjectCommand(program);
    asperity::addTradeOffCommand(program);
    asperity::addExtremesCommand(program);
    asperity::addExperimentCommand(program);
    asperity::addReplayCommand(program);
    asperity::addRenderCommand(program);
    asperity::addFilmCommand(program);
    asperity::addBundleCommand(program);
    asperity::addReportCommand(program);
    asperity::addCompareCommand(program);
    asperity::addLoopCommand(program);
    asperity::addBenchCommand(program);
    asperity::addDevicesCommand(program);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::ostringstream help;
        std::ostringstream complaint;
        const int status = program.exit(error, help, complaint);
        std::cout << help.str();
        std::cerr << asperity::printableLines(complaint.str());
        return status == 0 ? 0 : asperity::kWrongUsage;
    }
    return program.get_subcommands().empty() ? asperity::openWindow(*window) : 0;
}

}  // namespace

int main(int argc, char** argv) {
    asperity::openClosedStandardStreams();
    asperity::silenceVtk();
    // A file beyond the limit of the shell (ulimit -f) is then a full disk, not the end.
    (void)std::signal(SIGXFSZ, SIG_IGN);
    try {
        const int status = run(argc, argv);
        std::cout.flush();
        if (!std::cout) {
            throw asperity::Error("standard output could not be written");
        }
        return status;
    } catch (...) {
        return asperity::tellError(std::current_exception());
    }
}
