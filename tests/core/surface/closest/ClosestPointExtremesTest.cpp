#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/TestTip.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace asperity {
namespace {

using test::kNan;
using test::kTipRadius;

struct Extreme {
    std::string name;
    HeightMap map;
    double convergedShare = 0.99;  ///< of queries, at least
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Extreme& extreme, std::ostream* out) { *out << extreme.name; }

HeightMap mapOf(int columns, int rows, const std::function<double(int, int)>& height) {
    HeightMap map = flatMap(
        {.columns = columns, .rows = rows, .sizeX = columns * 2.0_nm, .sizeY = rows * 3.0_nm});
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            map.heights[map.index(row, column)] = height(row, column);
        }
    }
    return map;
}

std::vector<Extreme> extremes() {
    const auto noise = [](double range) {
        return [range, random = Random(5)](int, int) mutable { return range * random.uniform(); };
    };
    return {
        {"Constant", mapOf(16, 16, [](int, int) { return 4.0_nm; })},
        {"Spike", mapOf(17, 17, [](int r, int c) { return r == 8 && c == 8 ? 1.0_um : 0.0; })},
        {"Hole", mapOf(17, 17, [](int r, int c) { return r == 8 && c == 8 ? -1.0_um : 0.0; })},
        {"VerticalStep", mapOf(20, 20, [](int, int c) { return c < 10 ? 0.0 : 200.0_nm; })},
        {"NanRows", mapOf(16, 16, [=](int r, int c) { return r < 6 ? kNan : 0.1_nm * c; })},
        {"TwoByTwo", mapOf(2, 2, [](int r, int c) { return 3.0_nm * r * c; })},
        {"OneByOne", mapOf(1, 1, [](int, int) { return 1.0_nm; })},
        {"SingleRow", mapOf(30, 1, noise(4.0_nm))},
        {"SingleColumn", mapOf(1, 30, noise(4.0_nm))},
        {"Picometer", mapOf(32, 32, noise(1.0_pm))},
        // Slopes of a million: the search creeps along contour lines until its steps run out.
        {"Millimeter", mapOf(32, 32, noise(1e-3)), 0.95},
        {"Noise", mapOf(32, 32, noise(20.0_nm))},
    };
}

class ClosestPointOnExtremes : public testing::TestWithParam<Extreme> {};

/// Positions of a query: above, far above, on, and ten tip radii below the surface, also beside it.
std::vector<Vector3> queriesFor(const BSplineSurface& surface) {
    std::vector<Vector3> queries;
    Random random(8);
    for (int i = 0; i < 200; ++i) {
        const double x = random.uniform(-0.2, 1.2) * surface.sizeX();
        const double y = random.uniform(-0.2, 1.2) * surface.sizeY();
        const double height = surface.at(x, y).height;
        for (const double above :
             {kTipRadius, 0.0, 50.0 * kTipRadius, -10.0 * kTipRadius, -0.1_nm}) {
            queries.emplace_back(x, y, height + above);
        }
    }
    return queries;
}

TEST_P(ClosestPointOnExtremes, IsFiniteOnTheSurfaceAndNoFartherThanItsStart) {
    const BSplineSurface surface = fitSurface(GetParam().map);
    SearchGuess guess;
    int converged = 0;
    const std::vector<Vector3> queries = queriesFor(surface);
    for (const Vector3& query : queries) {
        const ClosestPoint closest = closestPoint(surface, query, guess);
        ASSERT_TRUE(closest.point.allFinite());
        ASSERT_NEAR(closest.normal.norm(), 1.0, 1e-12);
        ASSERT_TRUE(surface.contains(closest.point.x(), closest.point.y()));
        // The last step follows the tangent plane: rounding of position and height may differ.
        const HeightSample there = surface.at(closest.point.x(), closest.point.y());
        const double steep = std::abs(there.dx) + std::abs(there.dy);
        ASSERT_NEAR(there.height, closest.point.z(),
                    1e-15 * (surface.heightScale() +
                             steep * (surface.sizeX() + surface.sizeY() + query.norm())));
        ASSERT_NEAR(std::abs(closest.distance), (query - closest.point).norm(),
                    1e-12 * std::abs(closest.distance));
        ASSERT_LE(closest.iterations, 800);
        if (guess.valid) {
            const Vector3 start(guess.x, guess.y, surface.at(guess.x, guess.y).height);
            ASSERT_LE(std::abs(closest.distance), (query - start).norm() * (1.0 + 1e-12));
        }
        converged += closest.converged ? 1 : 0;
        guess = {.x = closest.point.x(), .y = closest.point.y(), .valid = true};
    }
    EXPECT_GE(converged, GetParam().convergedShare * static_cast<double>(queries.size()));
}

TEST_P(ClosestPointOnExtremes, MeetsTheGradientConditionWhereItConverges) {
    const BSplineSurface surface = fitSurface(GetParam().map);
    for (const Vector3& query : queriesFor(surface)) {
        const ClosestPoint closest = closestPoint(surface, query, {});
        if (!closest.converged || !closest.insideScan) {
            continue;
        }
        const HeightSample s = surface.at(closest.point.x(), closest.point.y());
        const Vector3 r = closest.point - query;
        const Vector3 alongX(1.0, 0.0, s.dx);
        const Vector3 alongY(0.0, 1.0, s.dy);
        // Rounding of position and height, as the slope and curvature there amplify it.
        const double bend = std::abs(s.dxx) + std::abs(s.dxy) + std::abs(s.dyy);
        const double scale = (surface.sizeX() + surface.heightScale() + r.norm()) *
                             (1.0 + alongX.norm() + alongY.norm()) *
                             (1.0 + alongX.norm() + alongY.norm() + r.norm() * bend +
                              r.norm() / surface.grid().pitchX);
        ASSERT_LT(std::abs(r.dot(alongX)), 1e-13 * scale);
        ASSERT_LT(std::abs(r.dot(alongY)), 1e-13 * scale);
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, ClosestPointOnExtremes, testing::ValuesIn(extremes()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
