#pragma once

#include "app/maps/MapJob.h"
#include "bench/BenchFolder.h"
#include "core/map/MapPlan.h"

#include <filesystem>

namespace asperity {

/// A time by the clock on the wall and by that of the thread, which other programs do not disturb.
struct MeasuredTime {
    double wall = 0.0;       ///< [s]
    double processor = 0.0;  ///< [s]
};

/// An approach map of this many quantities and pixels, over 1 µm.
[[nodiscard]] MapPlan benchPlan(MapGrid grid, std::size_t quantities);

/// Returns what a row costs rank 0 when all ranks make rows at once: it deals them out, takes them
/// and appends them to the part. All ranks call it.
/// @param threads of each other rank, which ask for as many rows at once; one: what a row waits for
/// its answer
[[nodiscard]] MeasuredTime rowCost(const MpiJob& job, const BenchFolder& folder,
                                   const MapPlan& plan, int threads);

/// Returns what a row costs without other processes: it is appended to the part.
[[nodiscard]] MeasuredTime keptRowCost(const BenchFolder& folder, const MapPlan& plan);

/// Returns what a force curve costs on the scene, averaged over rows across the scan.
[[nodiscard]] double pixelCost(const std::filesystem::path& scene);

/// Cost of the work done once, by one thread or few, for a scan of this many pixels a side. [s]
struct OnceCosts {
    double load = 0.0;   ///< of scan and surface, on each machine
    double write = 0.0;  ///< of all files of the map
};
[[nodiscard]] OnceCosts onceCosts(const BenchFolder& folder, int pixels, std::size_t quantities);

}  // namespace asperity
