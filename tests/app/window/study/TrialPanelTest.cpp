#include "app/window/study/TrialPanel.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(TrialResult, ALargestForceOfNoiseIsNone) {
    TrialRecord record;
    record.largestForce = 468e-12;
    EXPECT_EQ(resultWords(record, 0.1e-9).force, QStringLiteral("none above noise (100 pN)"));
    record.largestForce = 5e-9;
    EXPECT_EQ(resultWords(record, 0.1e-9).force, QStringLiteral("5 nN"));
}

}  // namespace
}  // namespace asperity
