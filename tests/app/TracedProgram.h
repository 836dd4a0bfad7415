#pragma once

#include <csignal>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace asperity::test {

/// Changes that a program has made to files so far.
struct FileProgress {
    std::uint64_t bytes = 0;  ///< written to regular files
    std::uint64_t steps = 0;  ///< files and folders made, renamed, removed
};

/// Where a program gets a signal: before the first system call by which it would exceed one of
/// these, or make what is named here.
struct SignalPoint {
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
    std::string made = {};  ///< end of a path that is made or renamed to; empty: of none
    int signal = SIGKILL;
};

struct TracedEnd {
    bool wasSignaled = false;  ///< it came to the point
    int exitCode = -1;         ///< of a program that ended by itself
    FileProgress progress;
};

/// Runs a program, without output, and sends it a signal by its progress: at the same place on a
/// machine of any load. What it starts itself is not counted.
/// @param words       the program's path and its arguments
/// @param environment NAME=VALUE, beside this process's own
TracedEnd runTraced(const std::vector<std::string>& words,
                    const std::vector<std::string>& environment = {},
                    const SignalPoint& point = {});

}  // namespace asperity::test
