#pragma once

#include <string>

namespace asperity::test {

/// Output of a run of the program and its end.
struct ProgramRun {
    int exitCode = -1;
    std::string output;  ///< stdout and stderr together

    /// Returns how many lines it printed besides those on how far its work is, of which there are
    /// more on a slower machine.
    [[nodiscard]] long lines() const;
};

/// Runs the command line of a shell.
[[nodiscard]] ProgramRun runCommand(const std::string& command);

/// Runs `asperity` with the arguments of a shell command line.
/// @param environment variables to set, as in "DISPLAY= CI=true"
[[nodiscard]] ProgramRun runProgram(const std::string& arguments,
                                    const std::string& environment = {});

}  // namespace asperity::test
