#include "hardware/woodenhaptics/WoodenHaptics.h"

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

TEST(RecentMaximum, RemembersTheLargestForOneToTwoSeconds) {
    RecentMaximum largest;
    EXPECT_EQ(largest.value(), 0.0);
    largest.add(3.0, 100.0);
    largest.add(5.0, 100.9);
    largest.add(1.0, 100.95);
    EXPECT_EQ(largest.value(), 5.0);
    largest.add(1.0, 101.8);
    EXPECT_EQ(largest.value(), 5.0);
    largest.add(2.0, 102.9);
    EXPECT_EQ(largest.value(), 2.0);
}

TEST(RecentMaximum, ForgetsAllInALongPause) {
    RecentMaximum largest;
    largest.add(5.0, 100.0);
    largest.add(1.0, 103.0);
    EXPECT_EQ(largest.value(), 1.0);
}

}  // namespace
}  // namespace asperity::test
