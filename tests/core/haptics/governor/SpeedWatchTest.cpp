#include "core/haptics/governor/ForceGovernor.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

/// The speeds told of a device that moves evenly, tick by tick.
template <typename See>
void moveEvenly(double speed, double rate, const See& see) {
    SpeedWatch watch;
    for (int i = 0; i < 200; ++i) {
        watch = watchSpeed(watch, {speed * i / rate, 0.0, 0.0}, 1.0 / rate);
        see(i / rate, watch.speed);
    }
}

TEST(SpeedWatch, TellsTheSpeedOfAnEvenMotionAtAnyRate) {
    for (const double rate : {100.0, 1000.0, 4000.0, 20000.0}) {
        moveEvenly(0.7, rate, [rate](double time, double told) {
            if (time >= 2e-3 + 1.0 / rate) {
                EXPECT_NEAR(told, 0.7, 1e-9) << rate << " Hz";
            }
        });
    }
}

TEST(SpeedWatch, TakesNoReportThatComesLessOftenThanTheTickForALeap) {
    constexpr double kRate = 20000.0;
    SpeedWatch watch;
    for (int i = 0; i < 2000; ++i) {
        const double reported = std::floor(i / 20.0) * 1e-3;  // the device reports at 1 kHz
        watch = watchSpeed(watch, {0.7 * reported, 0.0, 0.0}, 1.0 / kRate);
        EXPECT_LE(watch.speed, 1.0) << "of tick to tick it is 14 m/s";
    }
    EXPECT_GT(watch.speed, 0.5);
}

TEST(SpeedWatch, KnowsNothingOfTheWayToTheFirstPosition) {
    const SpeedWatch first = watchSpeed({}, {5.0, 0.0, 0.0}, 10e-3);
    EXPECT_EQ(first.speed, 0.0);
    EXPECT_EQ(watchSpeed(first, {5.0, 0.0, 0.0}, 10e-3).speed, 0.0);
}

TEST(SpeedWatch, ALeapBeyondAllNumbersIsFast) {
    const SpeedWatch far = watchSpeed({}, {1e308, 0.0, 0.0}, 10e-3);
    EXPECT_GT(watchSpeed(far, {-1e308, 0.0, 0.0}, 10e-3).speed, 1e300);
}

}  // namespace
}  // namespace asperity
