#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/probe/ProbeDescription.h"

#include <filesystem>

namespace asperity {

/// A probe file (TOML); every key is documented in docs/scene.md. What it leaves out is that of the
/// 14 N/m lever of the default scene. @throw InputError
[[nodiscard]] ProbeDescription readProbe(const std::filesystem::path& path);

/// The keys of a probe in any section, over `otherwise`. Unknown keys are left to the caller.
/// @throw InputError
[[nodiscard]] ProbeDescription readProbeKeys(TomlSection& section,
                                             const ProbeDescription& otherwise);

/// A probe file. @param notes that stand above it as comments, a line each
[[nodiscard]] std::string probeText(const ProbeDescription& probe, const std::string& notes);

/// Every key of a probe: reading them back gives the same probe.
[[nodiscard]] toml::table probeTable(const ProbeDescription& probe);

}  // namespace asperity
