#include "core/Units.h"
#include "core/haptics/DevicePath.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kFine = 0.1e-9;  // [m]

TEST(LiftStep, IsFineNearTheSample) {
    EXPECT_NEAR(liftedHeight(0.0, 1.0, kFine), kFine, 1e-18);
    EXPECT_NEAR(liftedHeight(0.2_nm, -1.0, kFine), kFine, 1e-18);
    EXPECT_NEAR(liftedHeight(-1.0_nm, -2.0, kFine), -1.2_nm, 1e-18);
    EXPECT_NEAR(liftedHeight(-1.0_nm, 0.1, kFine), -0.99_nm, 1e-18);
}

/// Five notches in a view of a scan 60 mm wide pressed with half a millinewton.
TEST(LiftStep, APressedLeverIsMovedByAFifthOfTheSetpointInTheWidestView) {
    EXPECT_NEAR(fineLiftStep(40.0_nm, 5e-9, 14.0), 0.1_nm, 1e-18);
    EXPECT_NEAR(fineLiftStep(10e-3, 5e-9, 14.0), 0.1_nm, 1e-18);
    EXPECT_NEAR(14.0 * fineLiftStep(10e-3, 50e-9, 14.0), 10e-9, 1e-18);
    EXPECT_NEAR(0.2 * fineLiftStep(1.0, 5e-9, 0.2), 1e-9, 1e-18);
    EXPECT_NEAR(fineLiftStep(10.0_nm, 5e-9, 0.2), 0.025_nm, 1e-18);
}

TEST(LiftStep, TakesAShareOfTheHeightFarAway) {
    for (const double height : {5.0_nm, 100.0_nm, 1.0_um}) {
        const double lowered = liftedHeight(height, -1.0, kFine);
        EXPECT_NEAR(lowered / height, 0.7788, 1e-4) << height;
        EXPECT_GT(liftedHeight(height, -40.0, kFine), -4.0_nm) << "no crash from " << height;
    }
}

TEST(LiftStep, AFewNotchesLeadFromFarToTheContact) {
    double height = 8.0_nm;
    int notches = 0;
    for (; height > 0.0; ++notches) {
        height = liftedHeight(height, -1.0, kFine);
    }
    EXPECT_LE(notches, 17);
    EXPECT_GT(height, -1.01 * kFine) << "the last step is a fine one";
}

TEST(LiftStep, StepsAddUpAndLeadBack) {
    for (const double height : {-2.0_nm, 0.05_nm, 0.4_nm, 0.41_nm, 7.0_nm}) {
        EXPECT_NEAR(liftedHeight(liftedHeight(height, -3.5, kFine), 3.5, kFine), height, 1e-20);
        EXPECT_NEAR(liftedHeight(liftedHeight(height, 1.0, kFine), 1.0, kFine),
                    liftedHeight(height, 2.0, kFine), 1e-20);
    }
}

}  // namespace
}  // namespace asperity
