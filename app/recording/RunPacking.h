#pragma once

#include "app/recording/RecordedRun.h"
#include "app/runs/RunFormat.h"

#include <filesystem>

namespace asperity {

struct Scene;

/// How the tables of a run are kept in its folder. @throw InputError where it holds no run
[[nodiscard]] RunFormat formatOf(const std::filesystem::path& folder);

/// Puts the text tables of a run that is complete into recording.h5; only when that is in place
/// they go. @throw Error, the text tables stay then
void packRun(const std::filesystem::path& folder);

/// Writes the text tables of a packed run; those of the log are made anew, to the last digit, from
/// its inputs.
/// @param folder of the run; @param out another one
/// @throw Error where the log is not the recorded one, naming the first tick; as replay()
void unpackRun(const std::filesystem::path& folder, const Scene& scene, const RecordedRun& run,
               const std::filesystem::path& out);

}  // namespace asperity
