// Smoothing and spline of a whole map beside a streaming copy and other programs.
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/Hills.h"
#include "bench/surface/FitPeer.h"
#include "core/Error.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/SeparableFit.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <sys/resource.h>

namespace asperity {

namespace {

constexpr int kRounds = 7;

double nanosecondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin)
        .count();
}

/// Largest memory of this process so far [bytes].
double peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

/// Best times of the rounds [ns]; one after the other in each round, so that all meet the same
/// machine.
struct Times {
    double copy = std::numeric_limits<double>::infinity();
    double oneThread = std::numeric_limits<double>::infinity();
    double twoThreads = std::numeric_limits<double>::infinity();
    double baseline = std::numeric_limits<double>::infinity();  ///< one thread, no wide vectors
};

Times measure(const ScanMap& map, double sigma) {
    const LineFit alongX(map.columns, sigma);
    const LineFit alongY(map.rows, sigma);
    PixelVector<float> target(map.heights.size(), 0.0F);
    Times times;
    const auto keep = [&](double& best, VectorUnit unit, int threads) {
        const auto begin = std::chrono::steady_clock::now();
        const auto controls = separableFit(map, alongX, alongY, nullptr, {unit, threads});
        best = std::min(best, nanosecondsSince(begin));
    };
    for (int round = 0; round < kRounds; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        std::memcpy(target.data(), map.heights.data(), map.heights.size() * sizeof(float));
        times.copy = std::min(times.copy, nanosecondsSince(begin));
        keep(times.oneThread, widestVectorUnit(), 1);
        keep(times.twoThreads, widestVectorUnit(), 2);
        keep(times.baseline, VectorUnit::Baseline, 1);
    }
    return times;
}

/// Largest difference from our control heights away from the borders, in units of the height range.
double difference(const BSplineSurface& surface, const FitAnswer& answer) {
    constexpr int kMargin = 40;
    const BSplineSurface::Grid& grid = surface.grid();
    const auto columns = static_cast<std::size_t>(grid.columns);
    double largest = 0.0;
    for (int row = kMargin; row < grid.rows - kMargin; ++row) {
        const auto top = static_cast<std::size_t>(grid.rows - 1 - row);
        for (int column = kMargin; column < grid.columns - kMargin; ++column) {
            const double theirs =
                answer.coefficients[top * columns + static_cast<std::size_t>(column)];
            largest = std::max(largest, std::abs(theirs - surface.control(row, column)));
        }
    }
    return largest / 1e-8;
}

/// Times of the peers [ns]; infinite: not installed.
struct PeerTimes {
    double best = std::numeric_limits<double>::infinity();
    double gwyddion = std::numeric_limits<double>::infinity();
};

PeerTimes comparePeers(const ScanMap& map, double sigma, const Times& times) {
    const BSplineSurface surface = fitSurface(map, {sigma, sigma});
    const FitTask task{.columns = map.columns,
                       .rows = map.rows,
                       .heights = {map.heights.begin(), map.heights.end()},
                       .sigma = sigma};
    PeerTimes peers;
    for (const auto& peer : fitPeers()) {
        try {
            FitAnswer answer = peer->fit(task);
            answer.time = std::min(answer.time, peer->fit(task).time);
            std::printf("%-24s %9.1f ms   ours is %6.1f times as fast; differs by %.1e of the "
                        "height range\n",
                        peer->name().c_str(), answer.time * 1e-6, answer.time / times.twoThreads,
                        difference(surface, answer));
            peers.best = std::min(peers.best, answer.time);
            peers.gwyddion = peer->name() == "Gwyddion" ? answer.time : peers.gwyddion;
        } catch (const Error& error) {
            std::printf("%-24s %s\n", peer->name().c_str(), error.what());
        }
    }
    return peers;
}

std::vector<BenchRow> rowsOf(int pixels, const Times& times, const PeerTimes& peers,
                             double memory) {
    const std::string fit = "smooth + fit " + std::to_string(pixels) + "^2: ";
    const auto over = [&times](double peer) {
        return std::isfinite(peer) ? std::optional(peer / times.twoThreads) : std::nullopt;
    };
    return {
        {.name = fit + "best peer over ours", .value = over(peers.best), .unit = "x", .goal = 7.0},
        {.name = fit + "Gwyddion over ours",
         .value = over(peers.gwyddion),
         .unit = "x",
         .goal = 12.0},
        {.name = fit + "ours over a copy of the floats",
         .value = times.twoThreads / times.copy,
         .unit = "x",
         .goal = 6.0,
         .kind = GoalKind::AtMost},
        {.name = fit + "one thread over two",
         .value = times.oneThread / times.twoThreads,
         .unit = "x",
         .goal = 1.7},
        {.name = fit + "memory over that of the floats",
         .value = memory,
         .unit = "x",
         .goal = 2.2,
         .kind = GoalKind::AtMost}};
}

void run(int pixels, double sigma, const BenchOptions& options) {
    double before = peakMemory();
    const ScanMap map = hills<ScanMap>(pixels);
    const double mapBytes = static_cast<double>(map.heights.size() * sizeof(float));
    before = std::min(before, peakMemory() - mapBytes);
    (void)separableFit(map, LineFit(pixels, sigma), LineFit(pixels, sigma));
    const double used = peakMemory() - before;

    const Times times = measure(map, sigma);
    std::printf("%d x %d pixels, sigma %g pixels, best of %d\n", pixels, pixels, sigma, kRounds);
    std::printf("streaming copy, float    %9.2f ms\n", times.copy * 1e-6);
    std::printf("fit, two threads         %9.2f ms   %6.1f copies\n", times.twoThreads * 1e-6,
                times.twoThreads / times.copy);
    std::printf("fit, one thread          %9.2f ms   %6.2f times as long\n", times.oneThread * 1e-6,
                times.oneThread / times.twoThreads);
    std::printf("fit, one thread, SSE2    %9.2f ms\n", times.baseline * 1e-6);
    std::printf("memory, map included     %9.2f maps\n", used / mapBytes);
    const PeerTimes peers = comparePeers(map, sigma, times);
    giveRows(rowsOf(pixels, times, peers, used / mapBytes), options);
}

int runBench(int argc, char** argv) {
    int pixels = 4096;
    double sigma = 1.5;
    BenchOptions options;
    CLI::App app("Smoothing and spline of a whole map, beside a copy and other programs");
    app.add_option("PIXELS", pixels, "along each side of the map")
        ->check(CLI::Range(100, 16384))
        ->capture_default_str();
    app.add_option("SIGMA", sigma, "of the smoothing [pixels]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    run(options.quick ? std::min(pixels, 2048) : pixels, sigma, options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
