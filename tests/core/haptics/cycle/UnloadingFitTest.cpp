#include "core/Random.h"
#include "core/haptics/cycle/CycleDetector.h"

#include <gtest/gtest.h>

#include <optional>

namespace asperity {
namespace {

constexpr double kLever = 14.0;         // [N/m]
constexpr double kForce = 20e-9;        // at the deepest position [N]
constexpr double kStep = 3e-12;         // of the base a tick [m]
constexpr double kForceSigma = 0.1e-9;  // [N]

/// Unloads a spring of this stiffness [N/m] on the lever, down to no force.
std::optional<Reading> unloaded(double stiffness, double sigma, double step = kStep) {
    Random random(11);
    const double together = kLever * stiffness / (kLever + stiffness);
    UnloadingFit fit;
    for (double way = 0.0; together * way < kForce; way += step) {
        const double exact = kForce - together * way;
        const double force = exact + sigma * random.normal();
        const double base = -kForce / together + way;
        const ForceDistancePoint point{.force = force,
                                       .sigma = sigma,
                                       .separation = base + force / kLever,
                                       .baseDistance = base};
        if (way == 0.0) {
            fit.restart(point, exact);
        } else {
            fit.take(point, exact);
        }
    }
    return fit.stiffness();
}

TEST(UnloadingFit, IsExactForASpringWithoutNoise) {
    for (const double stiffness : {0.5, 14.0, 500.0}) {
        EXPECT_NEAR(unloaded(stiffness, 0.0).value().value, stiffness, 1e-6 * stiffness);
    }
}

TEST(UnloadingFit, NoiseDoesNotBiasIt) {
    for (const double stiffness : {0.5, 14.0, 100.0}) {
        const Reading found = unloaded(stiffness, kForceSigma).value();
        EXPECT_NEAR(found.value, stiffness, 4.0 * found.sigma);
        EXPECT_LT(found.sigma, 0.1 * stiffness);
    }
}

TEST(UnloadingFit, AContactThatIsTooStiffForTheLeverHasNone) {
    EXPECT_FALSE(unloaded(3e4, kForceSigma));
}

TEST(UnloadingFit, HasNoneBeforeThereIsUnloading) {
    UnloadingFit fit;
    EXPECT_FALSE(fit.stiffness());
    fit.restart({.force = kForce}, kForce);
    fit.take({.force = kForce}, kForce);
    EXPECT_FALSE(fit.stiffness()) << "at rest";
    EXPECT_FALSE(unloaded(14.0, 0.0, 1e-9)) << "too few ticks";
}

TEST(UnloadingFit, AnAttractiveContactHasNone) {
    UnloadingFit fit;
    fit.restart({.force = -1e-9}, -1e-9);
    for (int i = 1; i < 20; ++i) {
        fit.take({.force = -1e-9 - i * 1e-11, .separation = i * 1e-12, .baseDistance = i * 2e-12},
                 -1e-9);
    }
    EXPECT_FALSE(fit.stiffness());
}

}  // namespace
}  // namespace asperity
