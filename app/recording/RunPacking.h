#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RecordedRun.h"
#include "app/runs/RunFolder.h"

#include <filesystem>

namespace asperity {

struct Scene;

/// Returns the format of a run's tables in its folder. @throw InputError where it holds no run
[[nodiscard]] RunFormat formatOf(const std::filesystem::path& folder);

/// Puts the text tables of a run that is complete into recording.h5; only when that is in place
/// they go. @throw Error, the text tables stay then
void packRun(const std::filesystem::path& folder);

/// Writes the text tables of a packed run; those of the log are computed again, to the last digit,
/// from its inputs.
/// @param folder of the run; @param out another one
/// @throw Error where the log is not the recorded one, naming the first tick; as replay()
void unpackRun(const std::filesystem::path& folder, const Scene& scene, const RecordedRun& run,
               const std::filesystem::path& out);

/// A part of a run, from one time since its first tick to another, both included [s].
struct RunSpan {
    double from = 0.0;
    double to = 0.0;
};

/// Writes a part of a run as a recording of its own, which replays from its first tick on.
/// @param run    from `folder`, of the loaded scene
/// @param target a folder without a run
/// @throw Error where no tick is in it, or a file cannot be written; as replayTicks()
void writeSlice(const std::filesystem::path& folder, const LoadedScene& loaded,
                const RecordedRun& run, const RunSpan& part, const std::filesystem::path& target);

}  // namespace asperity
