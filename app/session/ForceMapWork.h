#pragma once

#include "app/maps/HeldMap.h"
#include "core/Progress.h"

#include <memory>

namespace asperity {

/// What a force map of the window is made of: the scan that is open, and the scene as it is to be
/// mapped. The scene is copied by the work, which lets go of the run's then.
struct MapSubject {
    std::shared_ptr<const LoadedScene> present;
    SceneDescription description;
    MapPlan plan;
};

/// Threads that map in the window: the loop keeps a core of its own where there are two.
[[nodiscard]] int mapThreads();

/// Computes what the map lacks. @param map gets it before its first row: it is there, with the rows
/// that are finished, also where this throws @throw Canceled, Error
void computeHeldMap(MapSubject subject, std::shared_ptr<HeldMap>& map, Progress& progress);

/// Time of a pixel on one core [s], measured on some of a row in the middle of the map.
/// @throw Canceled, Error
[[nodiscard]] double measuredPixelTime(MapSubject subject, const Progress& progress);

}  // namespace asperity
