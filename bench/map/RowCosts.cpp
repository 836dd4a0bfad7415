#include "bench/map/RowCosts.h"

#include "app/loading/SceneLoader.h"
#include "app/maps/MapFiles.h"
#include "app/maps/MapJob.h"
#include "bench/Hills.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/map/MapPlan.h"

#include <chrono>
#include <ctime>
#include <thread>

namespace asperity {

namespace {

/// Since it was made, of the calling thread.
class Clock {
public:
    [[nodiscard]] MeasuredTime elapsed() const {
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin_;
        return {wall.count(), processorTime() - processor_};
    }

private:
    [[nodiscard]] static double processorTime() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    double processor_ = processorTime();
};

MeasuredTime perRow(const MeasuredTime& all, const MapPlan& plan) {
    return {all.wall / plan.grid.rows, all.processor / plan.grid.rows};
}

std::vector<double> madeRow(const MapPlan& plan) {
    std::vector<double> values(static_cast<std::size_t>(plan.grid.columns) *
                               plan.quantities.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = 1e-9 * static_cast<double>(i % 1000);
    }
    return values;
}

}  // namespace

MapPlan benchPlan(MapGrid grid, std::size_t quantities) {
    MapPlan plan{.grid = grid, .region = {0.0, 0.0, 1e-6, 1e-6}, .setpoint = 5e-9};
    for (const MapQuantity quantity : kValues<MapQuantity>) {
        if (hasQuantity(MapMode::Approach, *rowOf(quantity)) &&
            plan.quantities.size() < quantities) {
            plan.quantities.push_back(quantity);
        }
    }
    return plan;
}

MeasuredTime rowCost(const MpiJob& job, const BenchFolder& folder, const MapPlan& plan,
                     int threads) {
    job.requireSame("", "the measurement");  // all begin together
    const std::vector<double> row = madeRow(plan);
    if (job.rank() > 0) {
        followRows(
            job, [&row](int /*number*/, const CancelCheck& /*check*/) { return row; }, threads,
            nullptr);
        return {};
    }
    MapPart part(folder.file("part"), plan, "bench", PartUse::Replace);
    const Clock clock;
    // Rank 0 computes, too: slowly, so that nearly all rows come from the others.
    leadRows(
        job, part,
        [&row](int /*number*/, const CancelCheck& /*check*/) {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            return row;
        },
        1, nullptr);
    return perRow(clock.elapsed(), plan);
}

MeasuredTime keptRowCost(const BenchFolder& folder, const MapPlan& plan) {
    const std::vector<double> row = madeRow(plan);
    MapPart part(folder.file("part"), plan, "bench", PartUse::Replace);
    const Clock clock;
    for (int number = 0; number < plan.grid.rows; ++number) {
        part.keep(number, row);
    }
    return perRow(clock.elapsed(), plan);
}

double pixelCost(const std::filesystem::path& scene) {
    constexpr int kStride = 8;
    const LoadedScene loaded = loadScene(scene, {}, nullptr, ModelFit::Later);
    const MapPlan plan = planMap(loaded.scene, {.grid = MapGrid{96, 96}});
    const MapInstrument instrument(loaded.scene, false);
    const Clock clock;
    for (int row = kStride / 2; row < plan.grid.rows; row += kStride) {
        (void)mapRow(instrument, plan, row);
    }
    return clock.elapsed().processor / (plan.grid.columns * (plan.grid.rows / kStride));
}

OnceCosts onceCosts(const BenchFolder& folder, int pixels, std::size_t quantities) {
    const std::filesystem::path scan = folder.file("scan.gsf");
    writeHeightMap(scan, hills<HeightMap>(pixels), {.title = "Height"});
    const Clock loading;
    const LoadedScene loaded = loadScene(scan, {}, nullptr, ModelFit::Later);
    const double load = loading.elapsed().wall;
    const MapPlan plan = benchPlan({pixels, pixels}, quantities);
    MapPart part(folder.file("part"), plan, "bench", PartUse::Replace);
    const std::vector<double> row = madeRow(plan);
    for (int number = 0; number < pixels; ++number) {
        part.keep(number, row);
    }
    const Clock writing;
    writeMapFiles(MapFiles(folder.file("map.gwy")), loaded, plan, part, nullptr);
    return {.load = load, .write = writing.elapsed().wall};
}

}  // namespace asperity
