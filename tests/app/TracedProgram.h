#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace asperity::test {

/// What a program has done to files so far.
struct FileProgress {
    std::uint64_t bytes = 0;  ///< written to regular files
    std::uint64_t steps = 0;  ///< files and folders made, renamed, removed
};

/// Where a program is killed: before the system call by which it would exceed one of these.
struct KillPoint {
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
};

struct TracedEnd {
    bool wasKilled = false;
    int exitCode = -1;  ///< of a program that ended by itself
    FileProgress progress;
};

/// Runs `asperity`, without output, and kills it by its progress: the same on a machine of any
/// load. What it starts itself is not counted.
/// @param environment NAME=VALUE, beside this process's own
TracedEnd runTraced(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment, const KillPoint& point = {});

}  // namespace asperity::test
