#pragma once

#include "app/recording/ForceTrace.h"
#include "app/recording/RunDifferences.h"
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

/// What a run is called: its folder, or the bundle.
[[nodiscard]] std::string runName(const std::filesystem::path& run);
/// What two runs are called beside each other: their folders, with those that they are in where
/// they are called the same.
[[nodiscard]] std::pair<std::string, std::string> runNames(const std::filesystem::path& first,
                                                           const std::filesystem::path& second);

}  // namespace asperity
