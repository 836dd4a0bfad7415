#include "core/FormattedText.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(DurationText, IsToTheSecondTheMinuteOrATenthOfAnHour) {
    EXPECT_EQ(durationText(0.2), "0 s");
    EXPECT_EQ(durationText(119.0), "119 s");
    EXPECT_EQ(durationText(12.4 * 60.0), "12 min");
    EXPECT_EQ(durationText(3.4 * 3600.0), "3.4 h");
}

}  // namespace
}  // namespace asperity
