#pragma once

#include <chrono>
#include <filesystem>
#include <string_view>

namespace asperity {

/// The program Gwyddion (GPL, a process of its own), which reads what no format here does.
struct Gwyddion {
    std::filesystem::path program;             ///< empty: it is not installed, or not to be asked
    std::chrono::milliseconds timeout{30000};  ///< for all that is done on one file
};

/// The first program `gwyddion` in these folders.
/// @param folders separated by colons, as in PATH
[[nodiscard]] Gwyddion gwyddionIn(std::string_view folders);
/// Returns the program found by PATH.
[[nodiscard]] Gwyddion installedGwyddion();

}  // namespace asperity
