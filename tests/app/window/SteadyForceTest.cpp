#include "app/window/SteadyForce.h"

#include "app/window/ShownRecording.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <memory>

namespace asperity::test {
namespace {

TickSample tickAt(double time, double force, ContactBranch branch) {
    TickSample sample;
    sample.time = time;
    sample.output.estimate.force = Vector3(0.0, 0.0, force);
    sample.output.estimate.covariance = 1e-20 * Matrix3::Identity();
    sample.output.model.contact.branch = branch;
    return sample;
}

/// Noise made arrow and numbers wobble while nothing moved.
TEST(SteadyForce, IsTheMeanOfATenthOfASecondAndBeginsAnewWithAContact) {
    SteadyForce steady;
    TickSample sample = tickAt(0.0, 9e-9, ContactBranch::Far);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), 9e-9) << "nothing was taken yet";
    for (int i = 0; i < 1000; ++i) {
        sample = tickAt(1e-3 * i, 5e-9 + (i % 2 == 0 ? 1e-9 : -1e-9), ContactBranch::Bonded);
        steady.take(sample);
    }
    steady.apply(sample.output);
    EXPECT_NEAR(sample.output.estimate.force.z(), 5e-9, 0.02e-9);
    EXPECT_EQ(sample.output.estimate.covariance, 1e-20 * Matrix3::Identity());
    sample = tickAt(1.0, -2e-9, ContactBranch::Far);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), -2e-9) << "the mean is of the contact";
    steady.take(sample);
    for (int i = 1; i < 100; ++i) {
        sample = tickAt(1.0 + 1e-3 * i, 0.0, ContactBranch::Far);
        steady.take(sample);
    }
    steady.apply(sample.output);
    EXPECT_NEAR(sample.output.estimate.force.z(), -2e-9 / 100.0, 1e-20) << "all have one weight";
}

TEST(SteadyForce, IsNotSpoiltByAValueThatIsNoNumber) {
    SteadyForce steady;
    steady.take(tickAt(0.0, std::numeric_limits<double>::quiet_NaN(), ContactBranch::Bonded));
    steady.take(tickAt(1e-3, 3e-9, ContactBranch::Bonded));
    TickSample sample = tickAt(1e-3, 3e-9, ContactBranch::Bonded);
    steady.apply(sample.output);
    EXPECT_EQ(sample.output.estimate.force.z(), 3e-9);
}

/// Slow motion wobbled with the noise of each tick.
TEST(ShownRecording, HasTheSteadyForceWhileItPlaysAndThatOfTheTickElse) {
    ShownRecording recording(std::make_shared<const LoadedScene>(
                                 LoadedScene{.scene = buildScene(plainScene(), flatMap()),
                                             .format = "made for the test",
                                             .sha256 = "",
                                             .notes = {}}),
                             {}, tickAt(0.0, 4e-9, ContactBranch::Bonded));
    const auto force = [&recording] {
        return recording.snapshot({}).sample.output.estimate.force.z();
    };
    const auto play = [&recording](double speed, int ticks, double value) {
        recording.setPlaying(speed);
        for (int i = 0; i < ticks; ++i) {
            const double time = recording.ticks().back().time + 1e-3;
            const std::array next{tickAt(time, value, ContactBranch::Bonded)};
            recording.take(next, true);
        }
    };
    play(0.0, 1, 6e-9);
    EXPECT_EQ(force(), 6e-9);
    play(1.0, 99, 4e-9);
    EXPECT_NEAR(force(), 4.02e-9, 0.001e-9) << "the mean of a tenth of a second";
    play(0.1, 30, 0.0);
    EXPECT_LT(force(), 0.3e-9) << "of a tenth of that in slow motion";
    play(0.0, 0, 0.0);
    EXPECT_EQ(force(), 0.0);
    EXPECT_EQ(recording.ticks().size(), 131U);
}

}  // namespace
}  // namespace asperity::test
