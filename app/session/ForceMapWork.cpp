#include "app/session/ForceMapWork.h"

#include "app/loading/SceneLoader.h"
#include "app/maps/MapRun.h"
#include "core/AllowedCores.h"
#include "core/map/MapRow.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace asperity {

namespace {

/// With all terms of the model, as `asperity map` has it: no map must keep up with a tick.
LoadedScene mappedScene(MapSubject& subject) {
    LoadedScene scene =
        withDescription(*subject.present, subject.description, nullptr, ModelFit::Later);
    subject.present.reset();  // the run may adopt another model meanwhile
    return scene;
}

/// Some pixels of the middle row, with the pitch of the map.
MapPlan sampleOf(const MapPlan& plan) {
    constexpr int kPixels = 32;
    MapPlan sample = plan;
    const int row = plan.grid.rows / 2;
    const int columns = std::min(plan.grid.columns, kPixels);
    const int first = (plan.grid.columns - columns) / 2;
    sample.grid = {.columns = columns, .rows = 1};
    sample.region.left = plan.region.left + (first * plan.pitchX());
    sample.region.right = sample.region.left + (columns * plan.pitchX());
    sample.region.bottom = plan.region.bottom + ((plan.grid.rows - row - 1) * plan.pitchY());
    sample.region.top = sample.region.bottom + plan.pitchY();
    return sample;
}

}  // namespace

int mapThreads() { return std::max(1, allowedCores() - 1); }

void computeHeldMap(MapSubject subject, std::shared_ptr<HeldMap>& map, Progress& progress) {
    LoadedScene scene = mappedScene(subject);
    map = std::make_shared<HeldMap>(std::move(scene), subject.plan);
    computeMap(map->loaded().scene, map->plan(), map->part(), mapThreads(), &progress);
}

double measuredPixelTime(MapSubject subject, const Progress& progress) {
    const LoadedScene scene = mappedScene(subject);
    const MapPlan sample = sampleOf(subject.plan);
    const MapInstrument instrument(scene.scene, sample.truth);
    std::atomic<bool> ended = false;
    const auto begin = std::chrono::steady_clock::now();
    (void)mapRow(instrument, sample, 0, CancelCheck(&progress, ended, nullptr));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return took.count() / sample.grid.columns;
}

}  // namespace asperity
