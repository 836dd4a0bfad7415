#pragma once

#include "core/haptics/device/WoodenHapticsDescription.h"

#include <filesystem>

namespace asperity {

/// A device file (TOML) of a WoodenHaptics; every key is documented in docs/devices.md. Only what
/// its maker may not know can be left out: wrong geometry would push the wrong way. @throw
/// InputError
[[nodiscard]] WoodenHapticsDescription readWoodenHaptics(const std::filesystem::path& path);

}  // namespace asperity
