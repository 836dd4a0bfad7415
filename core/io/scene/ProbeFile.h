#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/probe/ProbeDescription.h"
#include "core/scene/SceneDescription.h"

#include <filesystem>

namespace asperity {

/// A probe file (TOML); every key is documented in docs/scene.md. What it leaves out is that of the
/// 14 N/m lever of the default scene. @throw InputError
[[nodiscard]] ProbeDescription readProbe(const std::filesystem::path& path);

/// The key of the lever's noise: of a scene, not of a probe file.
inline constexpr const char* kSignalNoise = "signal_noise_rad";

/// Reads the keys of a probe in any section over what the scene has. Unknown keys are left to the
/// caller. @throw InputError
void readProbeKeys(TomlSection& section, SceneDescription& scene);

/// A probe file. @param notes that stand above it as comments, a line each
[[nodiscard]] std::string probeText(const ProbeDescription& probe, const std::string& notes);

/// Returns every key of a probe: reading them back gives the same probe.
[[nodiscard]] toml::table probeTable(const ProbeDescription& probe);

}  // namespace asperity
