#include "app/commands/Commands.h"
#include "app/commands/WindowCommand.h"
#include "app/program/EndSignals.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/Version.h"
#include "vtkplugins/pictures/Display.h"

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
    for (const auto add : asperity::kCommands) {
        add(program);
    }
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
    // Who reads what is said may have read enough (| head): the files are written all the same.
    (void)std::signal(SIGPIPE, SIG_IGN);
    try {
        const int status = run(argc, argv);
        std::cout.flush();
        if (!std::cout) {
            throw asperity::Error("standard output could not be written");
        }
        return status;
    } catch (...) {
        return asperity::reportError(std::current_exception());
    }
}
