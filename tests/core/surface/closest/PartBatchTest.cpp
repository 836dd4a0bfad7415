#include "core/surface/closest/PartBatch.h"

#include "tests/core/surface/closest/RoughParts.h"

#include <gtest/gtest.h>

namespace asperity {

namespace {

class PartBatchOf : public test::PartsOf {};

TEST_P(PartBatchOf, HoldsTheHeightsAtTheCornersOfItsParts) {
    const double rounding = 1e-14 * (surface_.heightScale() + 5.0_nm);
    for (int i = 0; i < 200; ++i) {
        const PartBatch batch = randomBatch(i % 5);
        for (int lane = 0; lane < PartBatch::kLanes; ++lane) {
            const double x = batch.centerX[lane];
            const double y = batch.centerY[lane];
            const double halfX = batch.halfX[lane];
            const double halfY = batch.halfY[lane];
            EXPECT_NEAR(batch.net[0][0][lane], aboveDatum(x - halfX, y - halfY), rounding);
            EXPECT_NEAR(batch.net[0][3][lane], aboveDatum(x + halfX, y - halfY), rounding);
            EXPECT_NEAR(batch.net[3][0][lane], aboveDatum(x - halfX, y + halfY), rounding);
            EXPECT_NEAR(batch.net[3][3][lane], aboveDatum(x + halfX, y + halfY), rounding);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, PartBatchOf, testing::ValuesIn(test::mapsOfParts()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace asperity
