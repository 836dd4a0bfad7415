#include "core/haptics/SetpointApproach.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace asperity {
namespace {

constexpr double kTimeStep = 1e-3;  // [s]
const Vector3 kStart(10e-9, 20e-9, 30e-9);
constexpr double kSurface = 24e-9;   // [m]
constexpr double kStiffness = 14.0;  // [N/m]

const ApproachPlan kPlan{
    .setpoint = 5e-9, .speed = 10e-9, .baseline = 0.1, .dwell = 0.05, .maxDescent = 20e-9};

/// A sample that pulls for a nanometer and then pushes, on a lever whose free signal is not zero.
double springForce(double z) {
    const double depth = kSurface - z;
    const double force = depth < 0.0 ? 0.0 : kStiffness * depth - 2e-9;
    return force + 40e-9;
}

/// An approach and all that came of it.
struct Course {
    SetpointApproach approach;
    Vector3 base = kStart;
    Vector3 lowest = kStart;
    double force = 0.0;  ///< at which the dwell began, above the free one [N]

    template <class Force>
    Course(const ApproachPlan& plan, double duration, const Force& forceAt)
        : Course(plan, duration, forceAt, springForce) {}
    /// @param forceAt as measured @param sampleForce as it is
    template <class Force, class SampleForce>
    Course(const ApproachPlan& plan, double duration, const Force& forceAt,
           const SampleForce& sampleForce)
        : approach(plan, kStart) {
        double last = 0.0;
        for (int i = 0; i * kTimeStep < duration; ++i) {
            const ApproachPhase before = approach.phase();
            base = approach.advance(kTimeStep, last);
            if (before != ApproachPhase::Dwell && approach.phase() == ApproachPhase::Dwell) {
                force = sampleForce(base.z()) - sampleForce(kStart.z());
            }
            lowest = base.z() < lowest.z() ? base : lowest;
            last = forceAt(base.z());
        }
    }
};

TEST(SetpointApproach, StopsAtTheSetpointAboveTheBaselineAndReturnsToItsStart) {
    const Course run(kPlan, 2.0, springForce);
    EXPECT_TRUE(run.approach.hasEngaged());
    EXPECT_EQ(run.approach.phase(), ApproachPhase::Done);
    EXPECT_NEAR(run.force, kPlan.setpoint, 1e-6 * kPlan.setpoint);
    const double step = kStiffness * kPlan.speed * kTimeStep;  // of the force in a tick
    const double largest = springForce(run.lowest.z()) - springForce(kStart.z());
    EXPECT_LE(largest, kPlan.setpoint + 1.01 * step);
    EXPECT_EQ(run.base, kStart);
    EXPECT_EQ(run.lowest.head<2>(), kStart.head<2>()) << "straight down";
}

TEST(SetpointApproach, RestsFirstAndDwellsAsLongAsAsked) {
    SetpointApproach approach(kPlan, kStart);
    int resting = 0;
    int dwelling = 0;
    double last = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vector3 base = approach.advance(kTimeStep, last);
        last = springForce(base.z());
        resting += approach.phase() == ApproachPhase::Baseline ? 1 : 0;
        dwelling +=
            approach.phase() == ApproachPhase::Settling || approach.phase() == ApproachPhase::Dwell
                ? 1
                : 0;
        if (approach.phase() == ApproachPhase::Baseline) {
            ASSERT_EQ(base, kStart);
        }
    }
    EXPECT_NEAR(resting, 100, 2);
    EXPECT_NEAR(dwelling, 50, 2);
}

TEST(SetpointApproach, WithoutAContactItEndsAtItsLimitAndReturns) {
    const Course run(kPlan, 5.0, [](double) { return 40e-9; });
    EXPECT_FALSE(run.approach.hasEngaged());
    EXPECT_EQ(run.approach.phase(), ApproachPhase::Done);
    EXPECT_NEAR(kStart.z() - run.lowest.z(), kPlan.maxDescent, 1e-18);
    EXPECT_EQ(run.base, kStart);
}

TEST(SetpointApproach, StaysAtTheSetpointWhereTheDwellHasNoEnd) {
    ApproachPlan plan = kPlan;
    plan.dwell = std::numeric_limits<double>::infinity();
    const Course run(plan, 5.0, springForce);
    EXPECT_EQ(run.approach.phase(), ApproachPhase::Dwell);
    EXPECT_NEAR(run.base.z(), run.lowest.z(), 1.01 * plan.speed * kTimeStep);
    EXPECT_NEAR(run.force, plan.setpoint, 1e-6 * plan.setpoint);
}

/// A soft sphere on the same lever: the force rises ever faster [N].
double sphereForce(double z) {
    constexpr double kSphere = 3.8e5;  // 4/3 E* sqrt(R) [N/m^(3/2)]: 2.3 GPa, 15 nm
    const double depth = kSurface - z;
    double low = 0.0;
    double high = std::max(depth, 0.0);
    for (int i = 0; i < 40; ++i) {
        const double indented = 0.5 * (low + high);
        const bool isBelow = kSphere * std::pow(indented, 1.5) < kStiffness * (depth - indented);
        (isBelow ? low : high) = indented;
    }
    return kSphere * std::pow(low, 1.5);
}

/// Mean and standard error of forces.
struct MeanForce {
    RunningMoments moments;

    [[nodiscard]] double bias(double setpoint) const {
        return (moments.mean() - setpoint) / moments.meanDeviation();
    }
};

/// The first noisy value that reaches the setpoint comes early: by one to three deviations of the
/// noise the force was below the setpoint, the more the slower the descent.
TEST(SetpointApproach, TheForceIsTheSetpointOnAverageWhateverTheNoise) {
    for (const double deviation : {0.02e-9, 0.12e-9, 0.6e-9}) {
        MeanForce spring;
        MeanForce sphere;
        for (unsigned seed = 0; seed < 200; ++seed) {
            std::mt19937 random(seed);
            std::normal_distribution<double> noise(0.0, deviation);
            ApproachPlan plan = kPlan;
            plan.speed = 5e-9;
            plan.dwell = std::numeric_limits<double>::infinity();
            const auto measured = [&](const auto& forceAt) {
                return [&](double z) { return forceAt(z) + noise(random); };
            };
            const Course onSpring(plan, 3.2, measured(springForce));
            const Course onSphere(plan, 3.2, measured(sphereForce), sphereForce);
            ASSERT_TRUE(onSpring.approach.hasMeasured() && onSphere.approach.hasMeasured());
            spring.moments.add(onSpring.force);
            sphere.moments.add(onSphere.force);
        }
        EXPECT_LT(std::abs(spring.bias(kPlan.setpoint)), 4.0) << deviation;
        EXPECT_LT(std::abs(sphere.bias(kPlan.setpoint)), 4.0) << deviation;
        const double scatter = std::hypot(0.015 * kPlan.setpoint, 0.2 * deviation);
        EXPECT_LT(spring.moments.deviation(), scatter) << "a mean at rest";
        EXPECT_LT(sphere.moments.deviation(), scatter);
    }
}

/// What is stated as measured is there within what is stated, baseline and all.
TEST(SetpointApproach, MeasuresWithinTheDeviationThatItStates) {
    RunningMoments errors;
    for (unsigned seed = 0; seed < 300; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, 0.2e-9);
        ApproachPlan plan = kPlan;
        plan.baseline = 0.03;  // known no better than a mean at rest
        plan.dwell = std::numeric_limits<double>::infinity();
        const Course run(plan, 2.0, [&](double z) { return springForce(z) + noise(random); });
        ASSERT_TRUE(run.approach.hasMeasured());
        errors.add((run.approach.measuredForce() - run.force) / run.approach.measuredDeviation());
    }
    EXPECT_LT(std::abs(errors.mean()), 4.0 * errors.meanDeviation());
    EXPECT_NEAR(errors.deviation(), 1.0, 0.17);
}

// A sixth of the setpoint is the noise; of 20,000 ticks far from the sample some are above it.
TEST(SetpointApproach, NoiseNeitherEndsTheDescentNorKeepsItFromEnding) {
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0.0, 1.5e-9);
        ApproachPlan plan = kPlan;
        plan.speed = 1e-9;
        const Course run(plan, 12.0, [&](double z) { return springForce(z) + noise(random); });
        EXPECT_TRUE(run.approach.hasEngaged()) << seed;
        EXPECT_LT(run.lowest.z(), kSurface) << "stopped in free air, seed " << seed;
        EXPECT_NEAR(run.force, plan.setpoint, 0.5 * plan.setpoint) << seed;
    }
}

TEST(SetpointApproach, AForceThatIsNoNumberEndsTheDescent) {
    const Course run(kPlan, 3.0, [](double z) {
        return z < 26e-9 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    });
    EXPECT_FALSE(run.approach.hasEngaged());
    EXPECT_GT(run.lowest.z(), 25.9e-9);
    EXPECT_EQ(run.base, kStart);
}

/// Over a step of the sample the force jumps past the setpoint: it would be lost above the step.
TEST(SetpointApproach, MeasuresTheForceThatIsThere) {
    constexpr double kThere = 7e-9;  // [N]
    ApproachPlan plan = kPlan;
    plan.dwell = std::numeric_limits<double>::infinity();
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0,
                                           1.5e-9);  // so that a mean of some ticks is compared
    const Course run(
        plan, 5.0, [&](double z) { return (z < kSurface ? kThere : 0.0) + 40e-9 + noise(random); });
    ASSERT_TRUE(run.approach.hasMeasured());
    const double deviation = run.approach.measuredDeviation();
    EXPECT_GT(deviation, 0.1e-9);
    EXPECT_LT(deviation, plan.setpoint / 6.0 + 0.2e-9);
    EXPECT_NEAR(run.approach.measuredForce(), kThere, 4.0 * deviation);
    const Course still(plan, 5.0, [](double z) { return z < kSurface ? kThere : 0.0; });
    EXPECT_EQ(still.approach.measuredForce(), kThere);
    EXPECT_EQ(still.approach.measuredDeviation(), 0.0);
}

/// Without an equilibrium the descent ends, but not for a tick or two.
TEST(SetpointApproach, EndsWhereTheTipHasNoEquilibrium) {
    const auto lowestOf = [](int unsolvedTicks) {
        SetpointApproach approach(kPlan, kStart);
        double lowest = kStart.z();
        int unsolved = 0;
        double z = kStart.z();
        for (int i = 0; i < 5000; ++i) {
            const bool isThere = z < kStart.z() - 2e-9 && unsolved < unsolvedTicks;
            unsolved += isThere ? 1 : 0;
            z = approach.advance(kTimeStep, 0.0, !isThere).z();
            lowest = std::min(lowest, z);
        }
        EXPECT_FALSE(approach.hasEngaged());
        EXPECT_EQ(approach.phase(), ApproachPhase::Done);
        EXPECT_EQ(approach.isBlocked(), unsolvedTicks >= 50);
        return lowest;
    };
    EXPECT_NEAR(lowestOf(49), kStart.z() - kPlan.maxDescent, 1e-18);
    EXPECT_NEAR(lowestOf(10000), kStart.z() - 2.5e-9, 0.05e-9);
}

TEST(RunningMoments, AreMeanAndDeviation) {
    RunningMoments moments;
    EXPECT_EQ(moments.deviation(), 0.0);
    for (const double value : {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0}) {
        moments.add(1e6 + value);
    }
    EXPECT_DOUBLE_EQ(moments.mean(), 1e6 + 5.0);
    EXPECT_NEAR(moments.deviation(), std::sqrt(32.0 / 7.0), 1e-9);
    EXPECT_NEAR(moments.meanDeviation(), std::sqrt(4.0 / 7.0), 1e-9);
}

TEST(RecentLine, IsThatThroughTheLastValues) {
    RecentLine line(5);
    for (int i = 0; i < 12; ++i) {
        EXPECT_EQ(line.isFull(), i >= 5);
        line.add(i < 7 ? 99.0 : 3.0 + 0.5 * i);
    }
    EXPECT_DOUBLE_EQ(line.end(), 3.0 + 0.5 * 11);
    RecentLine one;
    one.add(4.0);
    EXPECT_DOUBLE_EQ(one.end(), 4.0);
}

}  // namespace
}  // namespace asperity
