#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// A recording that was cut off by the end of its process or of the machine.
struct RecoveredRecording {
    std::filesystem::path folder;
    double duration = 0.0;  ///< [s]
    std::string problem;    ///< why it could not be recovered; empty: it was
};

/// Ends every recording in a folder of recordings that was cut off at its last whole tick, so that
/// all of its tables end there, and marks it as recovered. Those that a process still writes, and
/// all other folders, are not touched. Reads only the tables' ends.
[[nodiscard]] std::vector<RecoveredRecording>
recoverRecordings(const std::filesystem::path& recordings);

}  // namespace asperity
