#include "bench/BenchMain.h"
#include "bench/map/RowCosts.h"
#include "core/SiFormat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

// Measures what a row of a force map costs rank 0, and extrapolates to many cores (docs/maps.md):
//   mpirun -np 3 build/release/bin/asperity_map_bench

namespace asperity {

namespace {

constexpr int kSide = 8192;  // pixels of the map that is extrapolated to, a side
constexpr std::size_t kQuantities = 3;
constexpr std::size_t kAllQuantities = 14;
constexpr int kMeasuredSide = 2048;
constexpr int kRows = 2000;
constexpr int kManyThreads = 16;

void printCost(const char* what, const MeasuredTime& time) {
    std::printf("%-48s %9s by the wall, %9s of the thread\n", what,
                formatSi(time.wall, "s").c_str(), formatSi(time.processor, "s").c_str());
}

/// All that the law has. [s]
struct MapCosts {
    double pixel = 0.0;
    double leaderRow = 0.0;  ///< of rank 0, a row
    double wait = 0.0;       ///< of a thread for its next row
    OnceCosts once;

    [[nodiscard]] double row() const { return kSide * pixel; }
    /// Rows are handed out one by one, and by rank 0 alone.
    [[nodiscard]] double rowsOn(int cores) const {
        const int workers = std::min(cores, kSide);
        const double rounds = std::ceil(static_cast<double>(kSide) / workers);
        return std::max(rounds * (row() + (cores > 1 ? wait : 0.0)), kSide * leaderRow);
    }
    [[nodiscard]] double timeOn(int cores) const { return once.load + rowsOn(cores) + once.write; }
};

void printTable(const MapCosts& costs) {
    std::printf("\n%d x %d pixels, %zu quantities; a row takes %.3g s, rank 0 %s of it:\n"
                "no more than %.0f cores are kept busy by it, and no more than %d by the rows\n",
                kSide, kSide, kQuantities, costs.row(), formatSi(costs.leaderRow, "s").c_str(),
                costs.row() / costs.leaderRow, kSide);
    std::printf("%8s %14s %14s %11s %11s %s\n", "cores", "rows [s]", "all [s]", "speed-up",
                "efficiency", "without loading and writing");
    for (const int cores : {1, 2, 16, 256, 10000}) {
        const double speedUp = costs.timeOn(1) / costs.timeOn(cores);
        std::printf("%8d %14.4g %14.4g %11.4g %9.1f %% %9.1f %%\n", cores, costs.rowsOn(cores),
                    costs.timeOn(cores), speedUp, 100.0 * speedUp / cores,
                    100.0 * costs.rowsOn(1) / costs.rowsOn(cores) / cores);
    }
}

/// To the size of the map, by the number of pixels.
OnceCosts atFullSize(const OnceCosts& measured) {
    constexpr double kFactor = static_cast<double>(kSide / kMeasuredSide) * (kSide / kMeasuredSide);
    return {.load = kFactor * measured.load, .write = kFactor * measured.write};
}

/// The measurements that all ranks take part in.
struct HandedOut {
    MeasuredTime tiny;
    MeasuredTime few;
    MeasuredTime all;
    MeasuredTime wait;
};

HandedOut handedOut(const MpiJob& job, const BenchFolder& folder) {
    return {.tiny = rowCost(job, folder, benchPlan({1, kRows}, 1), kManyThreads),
            .few = rowCost(job, folder, benchPlan({kSide, kRows}, kQuantities), kManyThreads),
            .all = rowCost(job, folder, benchPlan({kSide, kRows}, kAllQuantities), kManyThreads),
            .wait = rowCost(job, folder, benchPlan({1, kRows}, 1), 1)};
}

int run(int /*argc*/, char** /*argv*/) {
    const MpiJob job;
    const BenchFolder folder;
    const HandedOut rows = job.isAlone() ? HandedOut() : handedOut(job, folder);
    if (job.rank() > 0) {
        return 0;
    }
    std::printf("%d processes; a row of a map, rank 0:\n", job.size());
    printCost("1 pixel, kept", keptRowCost(folder, benchPlan({1, kRows}, 1)));
    printCost("8192 pixels, 3 quantities, kept",
              keptRowCost(folder, benchPlan({kSide, kRows}, kQuantities)));
    printCost("8192 pixels, 14 quantities, kept",
              keptRowCost(folder, benchPlan({kSide, kRows}, kAllQuantities)));
    if (job.isAlone()) {
        std::printf("under mpirun -np 3 rows are handed out, too\n");
        return 0;
    }
    printCost("1 pixel, handed out and kept", rows.tiny);
    printCost("8192 pixels, 3 quantities, handed out and kept", rows.few);
    printCost("8192 pixels, 14 quantities, handed out and kept", rows.all);
    const int followers = job.size() - 1;
    const MeasuredTime wait{rows.wait.wall * followers, rows.wait.processor * followers};
    printCost("a thread waits for its next row", wait);
    const OnceCosts once = onceCosts(folder, kMeasuredSide, kQuantities);
    std::printf("%d x %d pixels: loaded in %.3g s, files of %zu quantities written in %.3g s\n",
                kMeasuredSide, kMeasuredSide, once.load, kQuantities, once.write);
    const MapCosts costs{.pixel = pixelCost(ASPERITY_SCENE),
                         .leaderRow = rows.few.processor,
                         .wait = wait.wall,
                         .once = atFullSize(once)};
    std::printf("a force curve: %s\n", formatSi(costs.pixel, "s").c_str());
    printTable(costs);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::run); }
