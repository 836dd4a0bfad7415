#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// A program to run and the bounds that it is kept in.
struct ProgramCall {
    std::filesystem::path program;
    std::vector<std::string> arguments;    ///< behind the program's name
    std::vector<std::string> environment;  ///< NAME=VALUE; it gets no other
    std::filesystem::path folder;          ///< the one that it starts in
    std::chrono::steady_clock::time_point deadline;
    std::uint64_t maxOutput = std::uint64_t{1} << 20U;  ///< to its terminal [bytes]
    std::uint64_t maxFile = std::uint64_t{1} << 31U;    ///< each that it writes [bytes]
    std::uint64_t maxMemory = std::uint64_t{1} << 33U;  ///< its address space [bytes]
};

enum class ProgramEnd : std::uint8_t {
    Exited,
    Killed,  ///< by a signal, as when it crashed or wrote too large a file
    TimedOut,
    WroteTooMuch
};

struct ProgramOutcome {
    ProgramEnd end = ProgramEnd::Exited;
    int exitCode = 0;    ///< of one that exited
    std::string output;  ///< standard output and errors, as they came
};

/// Runs a program without a shell and without input, in a process group of its own, and waits for
/// its end. When this returns, no process of the group is left; where this process is killed
/// before, the program ends with it, but not what the program has started itself. It inherits no
/// open file; its signals are as at the start of a program. Any threads.
/// @throw Error when it cannot be started or waited for
[[nodiscard]] ProgramOutcome runProgram(const ProgramCall& call);

}  // namespace asperity
