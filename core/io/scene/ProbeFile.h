#pragma once

#include "core/Progress.h"
#include "core/io/scene/TomlFile.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/SceneDescription.h"

#include <filesystem>
#include <ostream>

namespace asperity {

/// A probe file (TOML); every key is documented in docs/scene.md. What it leaves out is that of the
/// 14 N/m lever of the default scene. @throw InputError
[[nodiscard]] ProbeDescription readProbe(const std::filesystem::path& path);

/// The key of the lever's noise: of a scene, not of a probe file.
inline constexpr const char* kSignalNoise = "signal_noise_rad";

/// Reads the keys of a probe in any section over what the scene has. Unknown keys are left to the
/// caller. @throw InputError
void readProbeKeys(TomlSection& section, SceneDescription& scene);

/// A probe file. @param notes above it as comments, a line each
[[nodiscard]] std::string probeText(const ProbeDescription& probe, const std::string& notes);

/// Returns every key of a probe: reading them back gives the same probe.
[[nodiscard]] toml::table probeTable(const ProbeDescription& probe);

/// Forces for every row of a table of signals (CSV), written as a table that repeats the row and
/// adds force, covariance, condition and case. All vectors and the covariance are in the lab frame;
/// a row that is no measurement has the case "invalid_input" and nan for its numbers. Nothing is
/// written unless the whole table can be read.
/// @param probe a probe file, see readProbe()
/// @throw InputError for a missing column, a cell that is no number, or volts without a
/// calibration;
///        Canceled
void writeForceEstimates(const std::filesystem::path& probe, const std::filesystem::path& cases,
                         std::ostream& out, Progress* progress = nullptr);

}  // namespace asperity
