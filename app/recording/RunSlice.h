#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RecordedRun.h"

#include <filesystem>

namespace asperity {

/// A part of a run, from one time of it to another, both included [s].
struct RunSpan {
    double from = 0.0;
    double to = 0.0;
};

/// Writes a part of a run as a recording of its own, which replays from its first tick on.
/// @param run    from `folder`, of the loaded scene
/// @param target a folder without a run
/// @throw Error where no tick is in it, or a file cannot be written; as replayTicks()
void writeSlice(const std::filesystem::path& folder, const LoadedScene& loaded,
                const RecordedRun& run, const RunSpan& span, const std::filesystem::path& target);

}  // namespace asperity
