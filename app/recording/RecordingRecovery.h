#pragma once

#include "core/Vector.h"

#include <filesystem>
#include <optional>
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

/// recording.json: what must be known of a recording that was cut off before it had a summary.
struct RecordingManifest {
    std::string sha256;  ///< of the scan's file; empty without one
    /// Size with which the scan, or its part, was read [m]; none: of an earlier version.
    std::optional<Vector2> size = std::nullopt;
    bool complete = false;   ///< false: it is being written, or was cut off
    bool recovered = false;  ///< it was cut off, and ends at the last tick that was whole
};

/// Puts it in place; that of a complete recording waits until the disk holds it. @throw Error
void writeManifest(const std::filesystem::path& folder, const RecordingManifest& manifest);

/// @return nothing where the folder holds none: it is no recording, or one of an older version
/// @throw InputError where it is damaged
[[nodiscard]] std::optional<RecordingManifest> readManifest(const std::filesystem::path& folder);

}  // namespace asperity
