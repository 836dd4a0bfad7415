#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RunComparison.h"
#include "app/recording/RunPlayback.h"
#include "core/Progress.h"

#include <filesystem>
#include <string>
#include <utility>

namespace asperity {

/// A recorded run as far as it can be compared with another one.
struct ComparedRun {
    std::string note;  ///< on a run that is not complete; empty: it is
    RunConditions conditions;
    ForceTrace trace;
};

/// @param input folder of a run, or a bundle
/// @throw InputError where it cannot be read, or the scan has changed since; Error; Canceled
[[nodiscard]] ComparedRun readComparedRun(const std::filesystem::path& input,
                                          Progress* progress = nullptr);

/// Returns the name of a run: its folder's, or the bundle's.
[[nodiscard]] std::string runName(const std::filesystem::path& run);
/// Returns the names of two runs beside each other: their folders', with those of the parent
/// folders where both are the same.
[[nodiscard]] std::pair<std::string, std::string> runNames(const std::filesystem::path& first,
                                                           const std::filesystem::path& second);

/// A recorded run and the scene that it was made on.
struct RunWithScene {
    LoadedScene loaded;
    RunOnDisk run;
    std::string note;  ///< on a run that is cut off, or may not be what was recorded; empty: none
};

/// @throw InputError where one of them cannot be read, or the scan has changed since; Canceled
[[nodiscard]] RunWithScene readRunWithScene(const std::filesystem::path& folder,
                                            Progress* progress = nullptr);

}  // namespace asperity
