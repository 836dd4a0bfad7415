#pragma once

#include "core/haptics/HapticTick.h"

#include <filesystem>

namespace asperity {

/// Writes what the first tick of a recording starts from, so that it replays to the same bits.
/// @throw Error when it cannot be written
void writeTickMemory(const std::filesystem::path& path, const TickMemory& memory);

/// @throw InputError
[[nodiscard]] TickMemory readTickMemory(const std::filesystem::path& path);

}  // namespace asperity
