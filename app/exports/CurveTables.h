#pragma once

#include "app/exports/RunPlots.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>
#include <span>
#include <string>

namespace asperity {

// Tables of what plots and pictures show: SI units, as each column's name ends, to 17 digits; whole
// or not at all.

/// One row a tick: force as estimated and as the model has it, contact, signals.
/// @throw Error; Canceled
void writeForcesTable(const std::filesystem::path& path, RunPlayback& run, Progress* progress);

/// The same of ticks that are at hand. @throw Error
void writeForcesTable(const std::filesystem::path& path, std::span<const TickSample> samples);

/// One row a point of curves of force over distance, curve by curve: its label, distance, force.
/// Points that are not finite are left out.
/// @param distance name of its column, "separation_m"
/// @throw Error
void writeForceCurvesTable(const std::filesystem::path& path, std::span<const Curve> curves,
                           const std::string& distance);

/// One row a tick of a cycle. @throw Error
void writeCycleTable(const std::filesystem::path& path, const std::vector<CyclePoint>& cycle);

/// One row a point of a deformed patch, bottom row first. @throw Error
void writePatchTable(const std::filesystem::path& path, const SurfacePatch& patch);

}  // namespace asperity
