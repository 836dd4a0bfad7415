#pragma once

#include "app/charts/Chart.h"
#include "app/recording/RunPlayback.h"
#include "core/deformation/ContactDeformation.h"
#include "core/haptics/cycle/CycleDetector.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// The charts of forces.png, of all of a run. @throw Canceled
[[nodiscard]] std::vector<Chart> forceCharts(RunPlayback& run, Progress* progress);

/// One tick of a force-distance curve.
struct CyclePoint {
    double time = 0.0;  ///< [s]
    CurveBranch branch = CurveBranch::Approach;
    ForceDistancePoint point;
};

/// The cycle that holds a tick, from where it begins to where the next one does. Ticks without a
/// point (no equilibrium) are left out. @throw Canceled
[[nodiscard]] std::vector<CyclePoint> cycleAround(RunPlayback& run, std::size_t tick,
                                                  Progress* progress);

/// Force over separation, with a dot at a moment.
[[nodiscard]] Chart cycleChart(const std::vector<CyclePoint>& cycle, const TickSample& moment);

// Tables of what plots and pictures show: SI units, as each column's name ends, to 17 digits; whole
// or not at all.

/// One row a tick: force as estimated and as the model has it, contact, signals.
/// @throw Error; Canceled
void writeForcesTable(const std::filesystem::path& path, RunPlayback& run, Progress* progress);

/// The same of ticks in memory. @throw Error
void writeForcesTable(const std::filesystem::path& path, std::span<const TickSample> samples);

/// One row a point of curves of force over distance, curve by curve: its label, distance, force.
/// Points that are not finite are left out.
/// @param distance name of its column, "separation_m"
/// @throw Error
void writeForceCurvesTable(const std::filesystem::path& path, std::span<const Curve> curves,
                           const std::string& distance);

/// One row a tick of a cycle. @throw Error
void writeCycleTable(const std::filesystem::path& path, const std::vector<CyclePoint>& cycle);

/// One row a point of a section, curve by curve: undeformed and deformed surface, tip.
/// @throw Error
void writeSectionTable(const std::filesystem::path& path, const ContactSection& section);

/// One row a point of a deformed patch, bottom row first. @throw Error
void writePatchTable(const std::filesystem::path& path, const SurfacePatch& patch);

}  // namespace asperity
