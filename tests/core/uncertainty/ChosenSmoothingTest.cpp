#include "core/Random.h"
#include "core/scene/Scene.h"
#include "core/uncertainty/LandmarkBudgets.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace asperity {
namespace {

constexpr double kBall = 60e-9;  // [m]
constexpr int kBallPixels = 64;  // of 1 nm

SceneDescription ballScene() {
    SceneDescription scene = test::plainScene();
    scene.choices.law = ContactLaw::Jkr;
    scene.probe.thickness = thicknessForStiffness(scene.probe, 0.01);
    scene.truth.stiffness = 0.01;
    scene.uncertainty.enabled = false;
    return scene;
}

HeightMap noisyBall(double noise, std::uint64_t seed) {
    HeightMap map{.columns = kBallPixels, .rows = kBallPixels, .pitchX = 1e-9, .pitchY = 1e-9};
    Random random(seed);
    for (int row = 0; row < kBallPixels; ++row) {
        for (int column = 0; column < kBallPixels; ++column) {
            const double x = (column - 31.5) * map.pitchX;
            const double y = (row - 31.5) * map.pitchY;
            map.heights.push_back(std::sqrt((kBall * kBall) - (x * x) - (y * y)) +
                                  (noise * random.normal()));
        }
    }
    return map;
}

/// Root mean square of the adhesion's relative error at 9 positions of 20 scans: on a soft lever
/// JKR's is 1.5 pi w R_eff.
double adhesionError(double noise, std::optional<double> smoothing) {
    SceneDescription description = ballScene();
    description.sample.smoothingPixels = smoothing;
    const double radius = 1.0 / ((1.0 / description.tip.radius) + (1.0 / kBall));
    const double truth =
        1.5 * std::numbers::pi * description.sample.material.workOfAdhesion * radius;
    double sum = 0.0;
    int count = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Scene scene = buildScene(description, noisyBall(noise, seed));
        for (const double x : {24e-9, 32e-9, 40e-9}) {
            for (const double y : {24e-9, 32e-9, 40e-9}) {
                const LandmarkBudgets budgets = budgetsAt(scene, Vector2(x, y), 1e-9);
                const double error =
                    (budgetOf(budgets, Landmark::AdhesionForce).value / truth) - 1.0;
                sum += error * error;
                ++count;
            }
        }
    }
    return std::sqrt(sum / count);
}

/// White noise of 30 pm at a pitch of 1 nm moved adhesion between 4.0 and 6.9 nN.
TEST(ChosenSmoothing, KeepsAdhesionWithinTheToleranceOfTheTrueOne) {
    const double tolerance = ballScene().tolerance;
    for (const double noise : {0.0, 10e-12, 30e-12, 100e-12}) {
        EXPECT_LT(adhesionError(noise, std::nullopt), tolerance) << noise;
    }
    EXPECT_GT(adhesionError(30e-12, 0.0), 4.0 * tolerance);
    EXPECT_GT(adhesionError(100e-12, 1.0), 1.5 * tolerance) << "the default of before";
}

}  // namespace
}  // namespace asperity
