#include "core/surface/closest/ExhaustiveSearch.h"

#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/closest/LocalClosestPoint.h"
#include "tests/core/surface/closest/BruteClosestPoints.h"
#include "tests/core/surface/closest/RoughSurface.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace asperity {
namespace {

using test::BruteClosestPoints;
using test::kNan;
using test::RoughMap;

/// Distances that differ by less are the same: a closest point may lie so much farther than the
/// nearest [m].
double allowance(double distance) { return 1e-6_nm + kSameDistance * std::abs(distance); }

struct RoughCase {
    RoughMap map;
    double certifiedShare = 0.0;  ///< of queries, at least
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const RoughCase& rough, std::ostream* out) { *out << rough.map.name; }

std::vector<RoughCase> roughCases() {
    const RoughMap base{.name = "", .columns = 40, .rows = 36};
    const auto with = [&](const std::string& name, double range, double smoothing) {
        RoughMap map = base;
        map.name = name;
        map.range = range;
        map.smoothing = smoothing;
        return map;
    };
    RoughMap wide = with("WidePixels", 10.0_nm, 1.0);
    wide.pitchX = 7.0_nm;
    RoughMap tall = with("TallPixels", 10.0_nm, 1.0);
    tall.pitchY = 7.0_nm;
    RoughMap far = with("FarOff", 5.0_nm, 1.0);
    far.offset = 1e-3;
    RoughMap row = with("SingleRow", 5.0_nm, 0.0);
    row.rows = 1;
    RoughMap column = with("SingleColumn", 5.0_nm, 0.0);
    column.columns = 1;
    RoughMap tiny = with("TwoByTwo", 3.0_nm, 0.0);
    tiny.columns = 2;
    tiny.rows = 2;
    return {{with("Smooth", 60.0_nm, 3.0), 0.99},
            {with("Moderate", 10.0_nm, 1.0), 0.99},
            {with("Steep", 100.0_nm, 1.5), 0.95},
            {with("Noise", 4.0_nm, 0.0), 0.99},
            {with("RoughNoise", 40.0_nm, 0.0), 0.8},
            {with("Picometer", 1.0_pm, 0.0), 0.99},
            {wide, 0.99},
            {tall, 0.99},
            {far, 0.99},
            {row, 0.99},
            {column, 0.99},
            {tiny, 0.99}};
}

/// Tip centers over, in, beside and far below a surface; radii from a tenth of a pixel to 100.
std::vector<Vector3> queriesAround(const BSplineSurface& surface, int count) {
    std::vector<Vector3> queries;
    Random random(21);
    const double pitch = std::sqrt(surface.grid().pitchX * surface.grid().pitchY);
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-0.15, 1.15) * surface.sizeX();
        const double y = random.uniform(-0.15, 1.15) * surface.sizeY();
        const double radius = pitch * std::pow(10.0, random.uniform(-1.0, 2.0));
        const double above = i % 6 == 5 ? -10.0 * radius : radius * random.uniform(0.7, 1.2);
        queries.emplace_back(x, y, surface.at(x, y).height + above);
    }
    for (const double x : {0.0, surface.sizeX()}) {
        for (const double y : {0.0, 0.5 * surface.sizeY(), surface.sizeY()}) {
            queries.emplace_back(x, y, surface.at(x, y).height + 4.0 * pitch);
            queries.emplace_back(x, y, surface.at(x, y).height);
        }
    }
    return queries;
}

class ClosestPointSearchOn : public testing::TestWithParam<RoughCase> {
protected:
    BSplineSurface surface_ = surfaceOf(GetParam().map);
};

TEST_P(ClosestPointSearchOn, NeverCallsAClosestPointNearestThatIsNot) {
    const BruteClosestPoints brute(surface_, 6);
    const std::vector<Vector3> queries = queriesAround(surface_, 250);
    SearchGuess guess;
    int certified = 0;
    for (const Vector3& query : queries) {
        const ClosestPoint closest = closestPoint(surface_, query, guess);
        guess = closest.guess();
        ASSERT_TRUE(surface_.contains(closest.point.x(), closest.point.y()));
        ASSERT_NE(closest.proof, SearchProof::NotSought);
        ASSERT_NE(closest.proof, SearchProof::OutOfReach);
        const double nearest = std::abs(brute.nearest(query).distance);
        if (closest.certified()) {
            ++certified;
            ASSERT_LE(std::abs(closest.distance), nearest + allowance(nearest))
                << query.transpose();
        }
    }
    EXPECT_GE(certified, GetParam().certifiedShare * static_cast<double>(queries.size()));
}

/// Smallest second derivative of half the squared distance at a closest point, 1 over a plane.
double leastBend(const BSplineSurface& surface, const Vector3& query, const ClosestPoint& closest) {
    const LocalModel model =
        HalfSquaredDistance(surface, query)({closest.point.x(), closest.point.y()});
    const Eigen::Matrix2d& h = model.hessian;
    return 0.5 * (h(0, 0) + h(1, 1)) - std::hypot(0.5 * (h(0, 0) - h(1, 1)), h(0, 1));
}

TEST_P(ClosestPointSearchOn, FindsTheSameClosestPointFromAnyGuess) {
    Random random(5);
    const double pitch = std::min(surface_.grid().pitchX, surface_.grid().pitchY);
    int ties = 0;
    for (const Vector3& query : queriesAround(surface_, 60)) {
        const ClosestPoint first = closestPoint(surface_, query, {});
        for (int i = 0; first.certified() && i < 10; ++i) {
            const Vector2 start = test::positionOn(surface_, random);
            const ClosestPoint closest =
                closestPoint(surface_, query, {start.x(), start.y(), true});
            if (!closest.certified()) {
                continue;
            }
            ASSERT_NEAR(std::abs(closest.distance), std::abs(first.distance),
                        allowance(first.distance));
            const double bend = closest.insideScan
                                    ? std::clamp(leastBend(surface_, query, closest), 1e-6, 1.0)
                                    : 1e-3;
            const bool same = (closest.point - first.point).head<2>().norm() < 1e-9 * pitch / bend;
            ties += same ? 0 : 1;
        }
    }
    EXPECT_LE(ties, 6);  // of 720
}

/// contactPoints promises every closest point within reach: none that brute force finds may be
/// missing.
TEST_P(ClosestPointSearchOn, ContactPointsMissNone) {
    const BruteClosestPoints brute(surface_, 6);
    const double pitch = std::sqrt(surface_.grid().pitchX * surface_.grid().pitchY);
    Random random(6);
    for (int i = 0; i < 80; ++i) {
        const double radius = pitch * std::pow(10.0, random.uniform(-0.3, 1.5));
        const Vector2 position = test::positionOn(surface_, random);
        const double z = surface_.at(position.x(), position.y()).height + radius;
        const TipSphere tip{.center = {position.x(), position.y(), z}, .radius = radius};
        const ContactPoints points = contactPoints(surface_, tip, 10.0_nm, {});
        if (points.proof != SearchProof::Nearest) {
            continue;
        }
        const auto known = points.list.all();
        ASSERT_TRUE(std::ranges::is_sorted(
            known, {}, [](const ClosestPoint& closest) { return std::abs(closest.distance); }));
        for (const ClosestPoint& sought : brute.near(tip.center)) {
            const double distance = std::abs(sought.distance);
            const bool matters = sought.converged &&
                                 distance < std::abs(known.front().distance) + 2.999_nm &&
                                 distance < tip.radius + 9.999_nm;
            const bool listed = std::ranges::any_of(known, [&](const ClosestPoint& closest) {
                return (closest.point - sought.point).norm() <= (kSamePoint + 1e-6) * radius;
            });
            const bool crowdedOut = known.size() == kMaxContactPoints &&
                                    distance >= std::abs(known.back().distance) - 1e-6_nm;
            ASSERT_TRUE(!matters || listed || crowdedOut)
                << tip.center.transpose() << " r " << radius << " foot "
                << sought.point.transpose();
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ClosestPointSearchOn, testing::ValuesIn(roughCases()),
                         [](const auto& parameter) { return parameter.param.map.name; });

struct Hard {
    std::string name;
    HeightMap map;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Hard& hard, std::ostream* out) { *out << hard.name; }

std::vector<Hard> hardMaps() {
    const ScanSize size{.columns = 24, .rows = 24, .sizeX = 48.0_nm, .sizeY = 72.0_nm};
    return {
        {"VerticalStep", test::mapOf(size, [](int, int c) { return c < 12 ? 0.0 : 200.0_nm; })},
        {"Spike", test::mapOf(size, [](int r, int c) { return r == 9 && c == 9 ? 1.0_um : 0.0; })},
        {"Hole", test::mapOf(size, [](int r, int c) { return r == 9 && c == 9 ? -1.0_um : 0.0; })},
        {"NanRows", test::mapOf(size, [](int r, int c) { return r < 6 ? kNan : 0.1_nm * r * c; })},
        {"Constant", test::mapOf(size, [](int, int) { return 4.0_nm; })},
    };
}

class ClosestPointSearchOnHard : public testing::TestWithParam<Hard> {};

TEST_P(ClosestPointSearchOnHard, NeverCallsAClosestPointNearestThatIsNot) {
    const BSplineSurface surface = fitSurface(GetParam().map);
    const BruteClosestPoints brute(surface, 12);
    int certified = 0;
    const std::vector<Vector3> queries = queriesAround(surface, 250);
    for (const Vector3& query : queries) {
        const ClosestPoint closest = closestPoint(surface, query, {});
        const double nearest = std::abs(brute.nearest(query).distance);
        if (closest.certified()) {
            ++certified;
            ASSERT_LE(std::abs(closest.distance), nearest + allowance(nearest))
                << query.transpose();
        }
    }
    EXPECT_GE(certified, 0.9 * static_cast<double>(queries.size()));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ClosestPointSearchOnHard, testing::ValuesIn(hardMaps()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Heights as a function of the distance from the middle of a square scan of 60 pixels.
template <class Profile>
BSplineSurface turned(const Profile& profile) {
    constexpr int kPixels = 60;
    const ScanSize size{
        .columns = kPixels, .rows = kPixels, .sizeX = kPixels * 1.0_nm, .sizeY = kPixels * 1.0_nm};
    return fitSurface(test::mapOf(size, [&](int row, int column) {
        return profile(std::hypot(row + 0.5 - 0.5 * kPixels, column + 0.5 - 0.5 * kPixels) *
                       1.0_nm);
    }));
}

/// Everywhere as near: no search can tell the closest points apart, and it must end all the same.
void expectManyPointsOrTheRightDistance(const BSplineSurface& surface, const Vector3& query) {
    const BruteClosestPoints brute(surface, 6);
    const double nearest = std::abs(brute.nearest(query).distance);
    const ClosestPoint closest = closestPoint(surface, query, {});
    EXPECT_TRUE(closest.proof == SearchProof::TooManyPoints || closest.certified());
    EXPECT_LE(std::abs(closest.distance),
              nearest + (closest.certified() ? allowance(nearest) : 0.1_nm));
    const TipSphere tip{.center = query, .radius = nearest};
    const ContactPoints points = contactPoints(surface, tip, 10.0_nm, {});
    EXPECT_TRUE(points.proof == SearchProof::TooManyPoints || points.proof == SearchProof::Nearest);
    EXPECT_LE(std::abs(points.list.all().front().distance), nearest + 0.1_nm);
}

/// A rough map that is the same from all four sides.
HeightMap mirroredMap(std::uint64_t seed) {
    HeightMap map = test::noisyMap({.name = "",
                                    .columns = 24 + static_cast<int>(seed % 2),
                                    .rows = 20,
                                    .range = 30.0_nm,
                                    .seed = seed});
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] = map.at(
                std::min(row, map.rows - 1 - row), std::min(column, map.columns - 1 - column));
        }
    }
    return map;
}

/// The middle of the scan is where parts of cells meet, and where the minima of a map that is the
/// same from all four sides stand: each must be found, and so must its mirror images.
TEST(ExhaustiveSearch, FindsMinimaWherePartsMeet) {
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const BSplineSurface surface = fitSurface(mirroredMap(seed), {.x = 1.5, .y = 1.5});
        const double middleX = 0.5 * surface.sizeX();
        const double middleY = 0.5 * surface.sizeY();
        const Vector3 query(middleX, middleY, surface.at(middleX, middleY).height + 12.0_nm);
        const ContactPoints points =
            contactPoints(surface, {.center = query, .radius = 12.0_nm}, 10.0_nm, {});
        const auto known = points.list.all();
        if (points.proof != SearchProof::Nearest || known.size() == kMaxContactPoints) {
            continue;
        }
        const ClosestPoint sought = BruteClosestPoints(surface, 6).nearest(query);
        ASSERT_NEAR(std::abs(known.front().distance), std::abs(sought.distance), 1e-6_nm);
        for (const ClosestPoint& closest : known) {
            const Vector3 mirrored(2.0 * middleX - closest.point.x(),
                                   2.0 * middleY - closest.point.y(), closest.point.z());
            ++found;
            ASSERT_TRUE(std::ranges::any_of(known, [&](const ClosestPoint& other) {
                return (other.point - mirrored).norm() < 1.01 * kSamePoint * 12.0_nm;
            })) << seed;
        }
    }
    EXPECT_GT(found, 60);
}

TEST(ExhaustiveSearch, EndsOnTheAxisOfACircularGroove) {
    const auto groove = [](double radius) {
        const double across = (radius - 18.0_nm) / 4.0_nm;
        return -6.0_nm * std::exp(-across * across);
    };
    const BSplineSurface surface = turned(groove);
    for (const double z : {-8.0_nm, 0.0, 12.0_nm}) {
        expectManyPointsOrTheRightDistance(surface, {30.0_nm, 30.0_nm, z});
    }
}

TEST(ExhaustiveSearch, EndsInTheCenterOfASphericalPit) {
    constexpr double kPit = 25.0_nm;
    const auto pit = [](double radius) {
        return radius < 20.0_nm ? -std::sqrt(kPit * kPit - radius * radius) : -15.0_nm;
    };
    const BSplineSurface surface = turned(pit);
    for (const double z : {0.0, 1e-6_nm, -1.0_nm, 3.0_nm}) {
        expectManyPointsOrTheRightDistance(surface, {30.0_nm, 30.0_nm, z});
    }
}

TEST(ExhaustiveSearch, EndsOnTheAxisOfACylindricalGroove) {
    const ScanSize size{.columns = 60, .rows = 60, .sizeX = 60.0_nm, .sizeY = 60.0_nm};
    const BSplineSurface surface = fitSurface(test::mapOf(size, [](int, int column) {
        const double across = (column + 0.5 - 30.0) * 1.0_nm;
        return 40.0_nm - std::sqrt(1600.0_nm * 1.0_nm - across * across);
    }));
    expectManyPointsOrTheRightDistance(surface, {30.0_nm, 30.0_nm, 40.0_nm});
}

/// On the axis of a mirrored map a search may run straight into a saddle.
TEST(ExhaustiveSearch, CallsNoSaddleAClosestPoint) {
    int saddles = 0;
    int converged = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const BSplineSurface surface = fitSurface(mirroredMap(seed), {.x = 1.5, .y = 1.5});
        const double x = 0.5 * surface.sizeX();
        const double y = 0.5 * surface.sizeY();
        for (const double above : {6.0_nm, 12.0_nm, 18.0_nm}) {
            const Vector3 query(x, y, surface.at(x, y).height + above);
            for (const SearchGuess& guess : {SearchGuess{}, SearchGuess{x, y, true}}) {
                const ClosestPoint closest = localClosestPoint(surface, query, guess);
                const HeightSample s = surface.at(closest.point.x(), closest.point.y());
                const double e = closest.point.z() - query.z();
                const double a = 1.0 + s.dx * s.dx + e * s.dxx;
                const double b = s.dx * s.dy + e * s.dxy;
                const double c = 1.0 + s.dy * s.dy + e * s.dyy;
                converged += closest.converged ? 1 : 0;
                saddles +=
                    closest.converged && closest.insideScan && (a < -1e-6 || a * c < b * b - 1e-6)
                        ? 1
                        : 0;
            }
        }
    }
    EXPECT_EQ(saddles, 0);
    EXPECT_GT(converged, 350);
}

}  // namespace
}  // namespace asperity
