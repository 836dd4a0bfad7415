#include "bench/scaling/FitTimes.h"

#include "core/surface/fit/BSplineFit.h"
#include "core/surface/fit/SeparableFit.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>

namespace asperity {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSigma = 1.5;  // of the smoothing [pixel]

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

double fitTime(const ScanMap& map) {
    const auto begin = Clock::now();
    const auto controls =
        separableFit(map, LineFit(map.columns, kSigma), LineFit(map.rows, kSigma));
    return secondsSince(begin);
}

double surfaceTime(ScanMap map) {
    const auto begin = Clock::now();
    const BSplineSurface surface = fitSurface(std::move(map), {kSigma, kSigma});
    return secondsSince(begin);
}

}  // namespace

FitTimes timeFits(std::span<const ScanMap> maps) {
    constexpr int kRounds = 11;
    const std::vector<double> never(maps.size(), std::numeric_limits<double>::infinity());
    FitTimes best{.fit = never, .surface = never};
    for (int round = 0; round < kRounds; ++round) {
        for (std::size_t i = 0; i < maps.size(); ++i) {
            best.fit[i] = std::min(best.fit[i], fitTime(maps[i]));
            best.surface[i] = std::min(best.surface[i], surfaceTime(maps[i]));
        }
    }
    return best;
}

}  // namespace asperity
