#include "ui/widgets/FrameCounter.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(FrameCounter, SaysNothingBeforeAFullSecond) {
    FrameCounter counter;
    counter.add(5.0);
    counter.add(5.5);
    EXPECT_FALSE(counter.rate());
    EXPECT_DOUBLE_EQ(counter.overallRate(), 2.0);
}

TEST(FrameCounter, CountsTheLastSecondAndAllOfThem) {
    FrameCounter counter;
    for (int i = 0; i <= 40; ++i) {
        counter.add(100.0 + 0.025 * i);  // one second at 40
    }
    EXPECT_NEAR(counter.rate().value(), 40.0, 1e-6);
    for (int i = 1; i <= 10; ++i) {
        counter.add(101.0 + 0.1 * i);  // and one at 10
    }
    EXPECT_NEAR(counter.rate().value(), 10.0, 1.0);
    EXPECT_NEAR(counter.overallRate(), 25.0, 1e-6);
}

TEST(FrameCounter, LeavesOutRests) {
    FrameCounter counter;
    counter.add(1.0);
    counter.add(1.1);
    counter.rest();
    counter.add(60.0);
    counter.add(60.1);
    EXPECT_NEAR(counter.overallRate(), 10.0, 1e-9);
}

}  // namespace
}  // namespace asperity
