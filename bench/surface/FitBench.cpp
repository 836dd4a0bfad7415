// Smoothing and spline of a whole map beside a streaming copy and other programs:
//   asperity_fit_bench [PIXELS [SIGMA]]       (default 4096 1.5)
#include "bench/Hills.h"
#include "bench/surface/FitPeer.h"
#include "core/Error.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/SeparableFit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
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

void comparePeers(const ScanMap& map, double sigma, const Times& times) {
    const BSplineSurface surface = fitSurface(map, {sigma, sigma});
    const FitTask task{.columns = map.columns,
                       .rows = map.rows,
                       .heights = {map.heights.begin(), map.heights.end()},
                       .sigma = sigma};
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double best = kInfinity;
    double gwyddion = kInfinity;
    for (const auto& peer : fitPeers()) {
        try {
            FitAnswer answer = peer->fit(task);
            answer.time = std::min(answer.time, peer->fit(task).time);
            std::printf("%-24s %9.1f ms   ours is %6.1f times as fast; differs by %.1e of the "
                        "height range\n",
                        peer->name().c_str(), answer.time * 1e-6, answer.time / times.twoThreads,
                        difference(surface, answer));
            best = std::min(best, answer.time);
            gwyddion = peer->name() == "Gwyddion" ? answer.time : gwyddion;
        } catch (const Error& error) {
            std::printf("%-24s %s\n", peer->name().c_str(), error.what());
        }
    }
    if (std::isfinite(best)) {
        std::printf("best of the others over ours        %6.1f   (target: at least 7)\n",
                    best / times.twoThreads);
    }
    if (std::isfinite(gwyddion)) {
        std::printf("Gwyddion over ours                  %6.1f   (target: at least 12)\n",
                    gwyddion / times.twoThreads);
    }
}

void run(int pixels, double sigma) {
    double before = peakMemory();
    const ScanMap map = hills<ScanMap>(pixels);
    const double mapBytes = static_cast<double>(map.heights.size() * sizeof(float));
    before = std::min(before, peakMemory() - mapBytes);
    (void)separableFit(map, LineFit(pixels, sigma), LineFit(pixels, sigma));
    const double used = peakMemory() - before;

    const Times times = measure(map, sigma);
    std::printf("%d x %d pixels, sigma %g pixels, best of %d\n", pixels, pixels, sigma, kRounds);
    std::printf("streaming copy, float    %9.2f ms\n", times.copy * 1e-6);
    std::printf("fit, two threads         %9.2f ms   %6.1f copies   (target: at most 10)\n",
                times.twoThreads * 1e-6, times.twoThreads / times.copy);
    std::printf("fit, one thread          %9.2f ms   %6.2f times as long   (target: 1.7)\n",
                times.oneThread * 1e-6, times.oneThread / times.twoThreads);
    std::printf("fit, one thread, SSE2    %9.2f ms\n", times.baseline * 1e-6);
    std::printf("memory, map included     %9.2f maps   (target: at most 2.2)\n", used / mapBytes);
    comparePeers(map, sigma, times);
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    try {
        const int pixels = argc > 1 ? std::atoi(argv[1]) : 4096;
        asperity::run(std::max(pixels, 100), argc > 2 ? std::atof(argv[2]) : 1.5);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
