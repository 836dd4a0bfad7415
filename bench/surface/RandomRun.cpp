#include "bench/surface/RandomRun.h"

#include "bench/surface/MethodRun.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::size_t kRestartEvery = 100;
constexpr int kRestarts = 10;
constexpr double kSamePosition = 1.0_pm;

SearchGuess guessFor(const SearchWork& work, const Vector3& center, int restart, Random& random) {
    constexpr double kAround = 3.0 * kBenchTipRadius;
    if (restart % 2 == 0) {
        return {center.x() + random.uniform(-kAround, kAround),
                center.y() + random.uniform(-kAround, kAround), true};
    }
    return {random.uniform(0.0, work.surface->sizeX()), random.uniform(0.0, work.surface->sizeY()),
            true};
}

void restart(const SearchWork& work, const Vector3& center, const ClosestPoint& first,
             Random& random, RandomResult& result) {
    bool different = false;
    bool tied = true;
    for (int i = 0; i < kRestarts; ++i) {
        const ClosestPoint other =
            closestPoint(*work.surface, center, guessFor(work, center, i, random));
        different = different || (other.point - first.point).norm() > kSamePosition;
        tied = tied && std::abs(std::abs(other.distance) - std::abs(first.distance)) <= kWrong;
    }
    ++result.restarted;
    result.different += different ? 1 : 0;
    result.tied += different && tied ? 1 : 0;
}

}  // namespace

RandomResult runRandom(const SearchWork& work, std::uint64_t seed) {
    constexpr std::size_t kDoubted = 100;  // queries that are looked at again
    const auto truth = referenceOf(work);
    Random random(seed);
    MethodResult judged;
    RandomResult result{.name = work.name,
                        .referenceDoubt = referenceDoubt(
                            work, truth, std::max<std::size_t>(truth.size() / kDoubted, 1))};
    for (std::size_t i = 0; i < work.centers.size(); ++i) {
        const ClosestPoint closest = closestPoint(*work.surface, work.centers[i], {});
        judge(work, i, {.position = closest.point.head<2>(), .certified = closest.certified()},
              truth[i], judged);
        if (i % kRestartEvery == 0) {
            restart(work, work.centers[i], closest, random, result);
        }
    }
    result.queries = judged.queries;
    result.wrong = judged.wrong;
    result.worst = judged.worst;
    result.below = judged.below;
    result.certified = judged.certified;
    result.certifiedWrong = judged.certifiedWrong;
    return result;
}

}  // namespace asperity
