#pragma once

#include "core/Vector.h"

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

/// recording.json: what must be known of a recording that was cut off before it had a summary.
struct RecordingManifest {
    std::string sha256;  ///< of the scan's file; empty without one
    /// That the scan, or the part of it, was read with [m]; none: one of an earlier version.
    std::optional<Vector2> size = std::nullopt;
    bool complete = false;   ///< false: it goes on, or it was cut off
    bool recovered = false;  ///< it was cut off, and ends at the last tick that was whole
};

/// Puts it in place; that of a complete recording waits until the disk holds it. @throw Error
void writeManifest(const std::filesystem::path& folder, const RecordingManifest& manifest);

/// @return nothing where the folder holds none: it is no recording, or one of an older version
/// @throw InputError where it is damaged
[[nodiscard]] std::optional<RecordingManifest> readManifest(const std::filesystem::path& folder);

}  // namespace asperity
