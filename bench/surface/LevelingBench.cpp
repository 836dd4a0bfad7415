// Time of each leveling step on a large scan in single precision, as a scene of it is leveled:
//   asperity_leveling_bench [PIXELS] [ROUNDS]     (default 8192 a side, 3)
#include "bench/Hills.h"
#include "core/surface/leveling/Leveling.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

namespace asperity {

namespace {

/// Seconds for the steps on a fresh copy; the median of some rounds.
double timeOf(const ScanMap& map, const LevelingSteps& steps, int rounds) {
    const LevelPoints points{Vector2(0.1 * map.sizeX(), 0.1 * map.sizeY()),
                             Vector2(0.9 * map.sizeX(), 0.2 * map.sizeY()),
                             Vector2(0.4 * map.sizeX(), 0.9 * map.sizeY())};
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round) {
        ScanMap copy = map;
        const auto start = std::chrono::steady_clock::now();
        copy = leveled(std::move(copy), steps, points);
        times.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

int run(int pixels, int rounds) {
    const ScanMap map = hills<ScanMap>(pixels);
    std::printf("%d x %d pixels in single precision, median of %d rounds\n", pixels, pixels,
                rounds);
    for (const LevelingStep step : kValues<LevelingStep>) {
        std::printf("%-22s %7.3f s\n", keyOf(step), timeOf(map, {step}, rounds));
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    try {
        return asperity::run(argc > 1 ? std::atoi(argv[1]) : 8192,
                             argc > 2 ? std::atoi(argv[2]) : 3);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
