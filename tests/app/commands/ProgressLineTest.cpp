#include "app/commands/ProgressLine.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Returns a log's text on a piece of work.
std::string logOf(std::chrono::seconds pause) {
    testing::internal::CaptureStderr();
    {
        ProgressLine line("evaluating", pause);
        for (const double fraction : {0.0, 0.101, 0.102, 1.0}) {
            line.report(fraction);
        }
    }
    return testing::internal::GetCapturedStderr();
}

/// A log showed nothing of many minutes of work.
TEST(ProgressLine, IsALineNowAndThenWhereThereIsNoTerminal) {
    EXPECT_EQ(logOf(std::chrono::seconds(0)),
              "evaluating 0 %\nevaluating 10 %\nevaluating 100 %\n");
}

TEST(ProgressLine, OfShortWorkIsNotInALog) { EXPECT_EQ(logOf(std::chrono::seconds(60)), ""); }

}  // namespace
}  // namespace asperity
