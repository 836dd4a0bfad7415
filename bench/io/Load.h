#pragma once

#include "bench/BenchFolder.h"
#include "bench/CommandOutput.h"
#include "core/Error.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

namespace asperity {

/// Loads of a file, each in a process of its own.
struct Load {
    std::string name;
    std::string command;                                    ///< prints what printLoad() prints
    double time = std::numeric_limits<double>::infinity();  ///< best of all runs [ns]
    /// Time of the whole process, from its start to its end, as `time` [ns].
    double whole = std::numeric_limits<double>::infinity();
    double sum = 0.0;  ///< of the heights [m]

    /// @return whether there was an answer
    bool tryRun() {
        const auto begin = std::chrono::steady_clock::now();
        const std::string line = firstLineOf(command);
        const std::chrono::duration<double, std::nano> all =
            std::chrono::steady_clock::now() - begin;
        char* rest = nullptr;
        const double taken = std::strtod(line.c_str(), &rest);
        if (rest == line.c_str()) {
            return false;
        }
        time = std::min(time, taken);
        whole = std::min(whole, all.count());
        sum = std::strtod(rest, nullptr);
        return true;
    }

    void run() {
        if (!tryRun()) {
            throw Error("no answer from: " + command);
        }
    }
};

/// This program again, loading a file.
inline std::string ownCommand(const std::string& way, const std::filesystem::path& file) {
    return quoted(std::filesystem::read_symlink("/proc/self/exe")) + " " + way + " " + quoted(file);
}

}  // namespace asperity
