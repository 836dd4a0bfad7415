#include "core/surface/closest/PartFacts.h"

#include "tests/core/surface/closest/RoughParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

class PartFactsOf : public test::PartsOf {
protected:
    /// A scan of no size: every part counts as one at its edge, of which all is said.
    static Box everything() { return {}; }

    /// @param limit half a squared distance [m^2]
    [[nodiscard]] PartFacts factsOf(const PartBatch& batch, const Vector3& query, double limit,
                                    const Box& scan) const {
        PartFacts facts;
        examine(batch,
                {.point = query - Vector3(0.0, 0.0, surface_.grid().datum),
                 .rounding = roundingOf(surface_, query),
                 .limit = limit,
                 .scan = scan},
                facts);
        return facts;
    }
};

TEST_P(PartFactsOf, KnowsTheDistanceAtItsCentersAndHowItsGradientDiffers) {
    for (int i = 0; i < 200; ++i) {
        const PartBatch batch = randomBatch(i % 5);
        const Vector3 query = queryAbove(batch, random_.uniform(-5.0, 15.0) * 1.0_nm);
        const PartFacts facts = factsOf(batch, query, 1.0, everything());
        for (int lane = 0; lane < PartBatch::kLanes; ++lane) {
            const LocalModel center = modelAt(query, batch.centerX[lane], batch.centerY[lane]);
            const Vector2 noise = 4.0 * center.gradientNoise;
            ASSERT_NEAR(facts.value[lane], center.value, 1e-9 * center.value);
            ASSERT_NEAR(facts.gradientX[lane], center.gradient.x(), noise.x());
            ASSERT_NEAR(facts.gradientY[lane], center.gradient.y(), noise.y());
            for (int k = 0; k < 20; ++k) {
                const double x = batch.centerX[lane] + random_.uniform(-1, 1) * batch.halfX[lane];
                const double y = batch.centerY[lane] + random_.uniform(-1, 1) * batch.halfY[lane];
                const LocalModel there = modelAt(query, x, y);
                const Vector2 off = (there.gradient - center.gradient).cwiseAbs();
                ASSERT_LE(off.x(), facts.spreadX[lane] + noise.x());
                ASSERT_LE(off.y(), facts.spreadY[lane] + noise.y());
                ASSERT_GE(there.hessian(0, 0), facts.bendX[lane] - 1e-6);
                ASSERT_GE(there.hessian(1, 1), facts.bendY[lane] - 1e-6);
            }
        }
    }
}

/// What a fact rules out must not be seen at any position of the part.
TEST_P(PartFactsOf, SaysNothingOfItsPartsThatIsNotSo) {
    int far = 0;
    int convex = 0;
    for (int i = 0; i < 600; ++i) {
        const PartBatch batch = randomBatch(i % 6);
        const Vector3 query = queryAbove(batch, random_.uniform(-5.0, 15.0) * 1.0_nm);
        const double limit = 0.5 * std::pow(random_.uniform(1.0, 20.0) * 1.0_nm, 2);
        const PartFacts facts = factsOf(batch, query, limit, everything());
        far += static_cast<int>(facts.far != 0);
        convex += static_cast<int>(facts.convex != 0);
        for (int lane = 0; lane < PartBatch::kLanes; ++lane) {
            const unsigned bit = 1U << static_cast<unsigned>(lane);
            for (int k = 0; k < 20; ++k) {
                const double x = batch.centerX[lane] + random_.uniform(-1, 1) * batch.halfX[lane];
                const double y = batch.centerY[lane] + random_.uniform(-1, 1) * batch.halfY[lane];
                const LocalModel there = modelAt(query, x, y);
                const Vector3 away = Vector3(x, y, surface_.at(x, y).height) - query;
                const Vector3 way(facts.way.x[lane], facts.way.y[lane], facts.way.z[lane]);
                ASSERT_GE(away.dot(way), facts.alongWay[lane] - 1e-9 * away.norm() * way.norm());
                ASSERT_GE(there.value, facts.least[lane] * (1.0 - 1e-9));
                if ((facts.far & bit) != 0) {
                    ASSERT_GE(there.value, limit * (1.0 - 1e-9));
                }
                if ((facts.convex & bit) != 0) {
                    ASSERT_GT(there.hessian(0, 0), -1e-6);
                    ASSERT_GT(there.hessian.determinant(), -1e-6);
                }
            }
        }
    }
    EXPECT_GT(far, 10);
    EXPECT_GT(convex, 10);
}

/// A minimum is put into a part at random; the part must not be said to hold none.
TEST_P(PartFactsOf, NeverDeniesAMinimum) {
    int minima = 0;
    for (int i = 0; i < 3000; ++i) {
        const PartBatch batch = randomBatch(i % 8);
        // On a side or a corner, too, where another part ends.
        const auto share = [&] { return std::clamp(random_.uniform(-1.5, 1.5), -1.0, 1.0); };
        const double x = batch.centerX[0] + share() * batch.halfX[0];
        const double y = batch.centerY[0] + share() * batch.halfY[0];
        const HeightSample s = surface_.at(x, y);
        const Vector3 query =
            Vector3(x, y, s.height) + random_.uniform(-5.0, 15.0) * 1.0_nm * s.normal();
        const Eigen::Matrix2d h = modelAt(query, x, y).hessian;
        if (h(0, 0) <= 1e-6 || h.determinant() <= 1e-6) {
            continue;
        }
        ++minima;
        const PartFacts facts = factsOf(batch, query, 1.0, everything());
        ASSERT_EQ(facts.withoutMinimum & 1U, 0U);
        ASSERT_EQ(facts.far & 1U, 0U);
    }
    EXPECT_GT(minima, 100);
}

/// A query has a minimum in a part: one that is farther away than the part is calm for must be the
/// one asked.
TEST_P(PartFactsOf, IsNotCalmForAQueryWithAMinimum) {
    int calm = 0;
    for (int i = 0; i < 5000; ++i) {
        const PartBatch batch = randomBatch(i % 6);
        const double x = batch.centerX[0] + random_.uniform(-1.0, 1.0) * batch.halfX[0];
        const double y = batch.centerY[0] + random_.uniform(-1.0, 1.0) * batch.halfY[0];
        const HeightSample s = surface_.at(x, y);
        const Vector3 held =
            Vector3(x, y, s.height) + random_.uniform(-5.0, 15.0) * 1.0_nm * s.normal();
        const Eigen::Matrix2d h = modelAt(held, x, y).hessian;
        if (h(0, 0) <= 1e-6 || h.determinant() <= 1e-6) {
            continue;
        }
        const double moved = std::pow(10.0, random_.uniform(-2.0, 1.0)) * 1.0_nm;
        const Vector3 way(random_.normal(), random_.normal(), random_.normal());
        const Vector3 query = held + moved * way.normalized();
        const PartFacts facts = factsOf(batch, query, 1.0, scanBox(surface_));
        ASSERT_LE(facts.calm[0], moved * (1.0 + 1e-9));
        calm += facts.calm[0] > 0.1 * moved ? 1 : 0;
    }
    // In a scan this small all parts are at the edge.
    if (std::min(surface_.grid().rows, surface_.grid().columns) >= 5) {
        EXPECT_GT(calm, 20);
    }
}

/// What is convex stays so for queries as near as it says.
TEST_P(PartFactsOf, StaysConvexForQueriesAround) {
    int convex = 0;
    for (int i = 0; i < 5000; ++i) {
        const PartBatch batch = randomBatch(i % 7);
        const Vector3 query = queryAbove(batch, random_.uniform(-5.0, 15.0) * 1.0_nm);
        const PartFacts facts = factsOf(batch, query, 1.0, scanBox(surface_));
        if ((facts.convex & 1U) == 0 || facts.convexFor[0] <= 0.0) {
            continue;
        }
        ++convex;
        for (int k = 0; k < 20; ++k) {
            const double x = batch.centerX[0] + random_.uniform(-1, 1) * batch.halfX[0];
            const double y = batch.centerY[0] + random_.uniform(-1, 1) * batch.halfY[0];
            const Vector3 way(0.0, 0.0, k % 2 == 0 ? 1.0 : -1.0);
            const LocalModel there =
                modelAt(query + std::min(facts.convexFor[0], 1.0_um) * way, x, y);
            ASSERT_GT(there.hessian(0, 0), -1e-6);
            ASSERT_GT(there.hessian.determinant(), -1e-6);
        }
    }
    if (std::min(surface_.grid().rows, surface_.grid().columns) >= 5) {
        EXPECT_GT(convex, 20);
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, PartFactsOf, testing::ValuesIn(test::mapsOfParts()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
