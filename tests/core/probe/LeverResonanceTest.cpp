#include "core/Error.h"
#include "core/probe/SimulatedAfm.h"
#include "tests/core/contact/laws/ContactCases.h"
#include "tests/support/ReferenceTable.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <rapidcheck.h>

namespace asperity {
namespace {

using std::numbers::pi;
using test::ReferenceTable;

/// Rounding of the row: the phase w0 t is known to half a unit in the last position, and turns into
/// that share of the motion which has not yet died out.
double phaseRounding(double phase, double qualityFactor) {
    return 4.0 * std::numeric_limits<double>::epsilon() * phase *
           std::exp(-0.5 * phase / qualityFactor);
}

TEST(LeverResonance, HasTheReferenceStepResponse) {
    const ReferenceTable table = test::referenceTable("T20_sdof_step.csv");
    ASSERT_EQ(table.rows(), 66U);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        SCOPED_TRACE(row);
        const double stiffness = table.number(row, "k");
        const double omega = 2.0 * pi * table.number(row, "f0");
        const double quality = table.number(row, "Q");
        const double force = table.number(row, "F0");
        const double time = table.number(row, "t");
        const double position = table.number(row, "z");
        const double velocity = table.number(row, "v");
        if (time == 0.0) {
            EXPECT_EQ(position, 0.0);
            EXPECT_EQ(velocity, 0.0);
            continue;
        }
        const LeverResonance lever({stiffness, omega, quality}, time);
        const OscillatorState state = lever.advanced({}, 0.0, force);
        const double amplitude = force / stiffness;
        const double rounding = phaseRounding(omega * time, quality);
        EXPECT_NEAR(state.position, position,
                    std::max(1e-12 * std::abs(position), rounding * amplitude));
        EXPECT_NEAR(state.velocity, velocity,
                    std::max(1e-12 * std::abs(velocity), rounding * amplitude * omega));
    }
}

/// Many short steps, or one long one; between them the base may move and the force change.
TEST(LeverResonance, DoesNotDependOnTheStep) {
    for (const double quality : {0.01, 0.3, 0.49, 0.5, 0.51, 1.0, 30.0, 1000.0}) {
        SCOPED_TRACE(quality);
        const Oscillator oscillator{14.0, 1e6, quality};
        constexpr double kTime = 3e-6;
        constexpr int kSteps = 300;
        const LeverResonance whole(oscillator, kTime);
        const LeverResonance part(oscillator, kTime / kSteps);
        const OscillatorState start{1e-9, -5e-4};
        OscillatorState state = start;
        for (int i = 0; i < kSteps; ++i) {
            state = part.advanced(state, 2e-9, 3e-8);
        }
        const OscillatorState expected = whole.advanced(start, 2e-9, 3e-8);
        EXPECT_NEAR(state.position, expected.position, 1e-21);
        EXPECT_NEAR(state.velocity, expected.velocity, 1e-15);
    }
}

/// The determinant of the free motion is exp(-w0 t / Q), and energy only goes down.
TEST(LeverResonance, LosesEnergyAtEveryDampingAndStep) {
    EXPECT_TRUE(rc::check([] {
        const double quality = *test::logUniform(1e-4, 1e6);
        const double time = *test::logUniform(1e-9, 1e6);
        const Eigen::Matrix2d free = LeverResonance({1.0, 1.0, quality}, time).propagator();
        RC_ASSERT(free.allFinite());
        RC_ASSERT(free.operatorNorm() <= 1.0 + 1e-13);
        const double expected = std::exp(-time / quality);
        RC_ASSERT(std::abs(free.determinant() - expected) < 1e-10);
    }));
}

TEST(LeverResonance, IsContinuousAcrossCriticalDamping) {
    const Eigen::Matrix2d critical = LeverResonance({1.0, 1.0, 0.5}, 2.0).propagator();
    EXPECT_NEAR(critical(0, 1), 2.0 * std::exp(-2.0), 1e-15);
    for (const double near : {0.5 - 1e-12, 0.5 + 1e-12}) {
        const Eigen::Matrix2d free = LeverResonance({1.0, 1.0, near}, 2.0).propagator();
        EXPECT_LT((free - critical).norm(), 1e-11);
    }
}

TEST(LeverResonance, RestsWhereTheBaseAndTheForcePutIt) {
    const LeverResonance lever({2.0, 1e5, 3.0}, 1.0);
    const OscillatorState rest = lever.advanced({1e-6, 1.0}, 1e-8, 4e-8);
    EXPECT_NEAR(rest.position, 3e-8, 1e-21);
    EXPECT_NEAR(rest.velocity, 0.0, 1e-15);
}

TEST(LeverResonance, RefusesWhatIsNoOscillator) {
    for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW((LeverResonance{{bad, 1.0, 1.0}, 1.0}), Error);
        EXPECT_THROW((LeverResonance{{1.0, bad, 1.0}, 1.0}), Error);
        EXPECT_THROW((LeverResonance{{1.0, 1.0, bad}, 1.0}), Error);
        EXPECT_THROW((LeverResonance{{1.0, 1.0, 1.0}, bad}), Error);
    }
}

}  // namespace
}  // namespace asperity
