#pragma once

#include "app/program/LoadedScene.h"
#include "app/recording/RunInputs.h"

#include <filesystem>
#include <string>

namespace asperity {

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
