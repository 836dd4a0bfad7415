#include "bench/surface/RandomRun.h"

#include "bench/surface/MethodRun.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/foot/ClosestPoint.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::size_t kRestartEvery = 100;
constexpr int kRestarts = 10;
constexpr double kSamePlace = 1.0_pm;

FootGuess guessFor(const FootWork& work, const Vector3& center, int restart, Random& random) {
    constexpr double kAround = 3.0 * kBenchTipRadius;
    if (restart % 2 == 0) {
        return {center.x() + random.uniform(-kAround, kAround),
                center.y() + random.uniform(-kAround, kAround), true};
    }
    return {random.uniform(0.0, work.surface->sizeX()), random.uniform(0.0, work.surface->sizeY()),
            true};
}

void restart(const FootWork& work, const Vector3& center, const SurfaceFoot& first, Random& random,
             RandomResult& result) {
    bool different = false;
    bool tied = true;
    for (int i = 0; i < kRestarts; ++i) {
        const SurfaceFoot other =
            closestPoint(*work.surface, center, guessFor(work, center, i, random));
        different = different || (other.point - first.point).norm() > kSamePlace;
        tied = tied && std::abs(std::abs(other.distance) - std::abs(first.distance)) <= kWrong;
    }
    ++result.restarted;
    result.different += different ? 1 : 0;
    result.tied += different && tied ? 1 : 0;
}

}  // namespace

RandomResult runRandom(const FootWork& work, std::uint64_t seed) {
    constexpr std::size_t kDoubted = 100;  // queries that are looked at again
    const auto truth = referenceOf(work);
    Random random(seed);
    MethodResult judged;
    RandomResult result{.name = work.name,
                        .referenceDoubt = referenceDoubt(
                            work, truth, std::max<std::size_t>(truth.size() / kDoubted, 1))};
    for (std::size_t i = 0; i < work.centers.size(); ++i) {
        const SurfaceFoot foot = closestPoint(*work.surface, work.centers[i], {});
        judge(work, i, {.place = foot.point.head<2>(), .certified = foot.certified()}, truth[i],
              judged);
        if (i % kRestartEvery == 0) {
            restart(work, work.centers[i], foot, random, result);
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
