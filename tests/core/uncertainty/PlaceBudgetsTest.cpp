#include "core/uncertainty/PlaceBudgets.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

const Vector2 kMiddle(64e-9, 64e-9);

/// On a soft lever, under JKR: the pull-off is 1.5 pi w R whatever the rest is.
SceneDescription softScene() {
    SceneDescription scene = test::plainScene();
    scene.choices.law = ContactLaw::Jkr;
    scene.probe.thickness = thicknessForStiffness(scene.probe, 0.01);
    scene.truth.stiffness = 0.01;
    return scene;
}

double relative(const PlaceBudgets& budgets, Landmark landmark, UncertaintyInput input) {
    const Budget& budget = budgetOf(budgets, landmark);
    return budget.share(input) / budget.value;
}

TEST(PlaceBudgets, AreThoseOfAClosedForm) {
    const Scene scene = buildScene(softScene(), test::flatMap());
    const PlaceBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
    const auto pull = [&](UncertaintyInput input) {
        return relative(budgets, Landmark::AdhesionForce, input);
    };
    EXPECT_NEAR(pull(UncertaintyInput::TipRadius), 0.1, 5e-3);
    EXPECT_NEAR(pull(UncertaintyInput::WorkOfAdhesion), 0.1, 5e-3);
    EXPECT_NEAR(pull(UncertaintyInput::Modulus), 0.0, 1e-6);
    EXPECT_NEAR(pull(UncertaintyInput::Stiffness), 0.0, 1e-6);
    EXPECT_NEAR(pull(UncertaintyInput::HeightNoise), 0.0, 1e-6) << "a flat scan without noise";
    const auto force = [&](UncertaintyInput input) {
        return relative(budgets, Landmark::NormalForce, input);
    };
    EXPECT_NEAR(force(UncertaintyInput::Stiffness), 0.1, 5e-3);
    EXPECT_NEAR(force(UncertaintyInput::InvOls), 0.03, 5e-4);
}

/// F ~ k InvOLS; with k ~ 1 / InvOLS^2 from a spectrum the force goes as 1 / InvOLS, and the
/// deviation of k holds that of InvOLS twice.
TEST(PlaceBudgets, AThermalStiffnessGoesWithTheInvOls) {
    SceneDescription description = softScene();
    description.uncertainty.thermalStiffness = true;
    const Scene scene = buildScene(description, test::flatMap());
    const PlaceBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
    EXPECT_NEAR(relative(budgets, Landmark::NormalForce, UncertaintyInput::InvOls), 0.03, 5e-4);
    EXPECT_NEAR(relative(budgets, Landmark::NormalForce, UncertaintyInput::Stiffness), 0.08, 4e-3);
}

TEST(PlaceBudgets, AreOffOnRequest) {
    SceneDescription description = softScene();
    description.uncertainty.enabled = false;
    const Scene scene = buildScene(description, test::hillyMap());
    for (const Budget& budget : budgetsAt(scene, kMiddle, 2e-9)) {
        EXPECT_EQ(budget.model(), 0.0);
        EXPECT_GT(budget.value, 0.0);
    }
}

/// Without a place: what a flat sample says but for the turn of its normal.
TEST(PlaceBudgets, OfALawAreThoseOfAFlatSample) {
    SceneDescription description = softScene();
    description.sample.shape = ShapeDescription{.kind = ShapeKind::Plane};
    description.uncertainty.surfaceNormal = 0.0;
    const Scene scene = buildScene(description);
    const PlaceBudgets ofPlace = budgetsAt(scene, {50e-9, 50e-9}, 2e-9);
    const PlaceBudgets ofLaw = budgetsOf(description, scene.belief.contact,
                                         scene.belief.cantilever.compliance()(2, 2), 2e-9);
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        const Budget& expected = budgetOf(ofPlace, row.value);
        const Budget& found = budgetOf(ofLaw, row.value);
        EXPECT_NEAR(found.value, expected.value, 1e-9 * expected.value) << row.key;
        EXPECT_NEAR(found.model(), expected.model(), 1e-6 * expected.model()) << row.key;
    }
}

/// The surface is inside its scan by the imaging tip, as a parallel surface: under JKR the pull-off
/// goes as the effective radius.
TEST(PlaceBudgets, TheImagingTipSharpensWhatItsScanShows) {
    HeightMap map = test::flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column - 31.5) * map.pitchX;
            const double y = (row - 31.5) * map.pitchY;
            map.heights[map.index(row, column)] = 8e-9 * std::exp(-((x * x) + (y * y)) / 900e-18);
        }
    }
    constexpr double kImaging = 10e-9;  // [m]
    Scene scene = buildScene(softScene(), map);
    scene.description.sample.imagingTipRadius = kImaging;
    const HeightSample top = scene.surface.at(kMiddle.x(), kMiddle.y());
    const double curvature = -0.5 * (top.dxx + top.dyy);
    const auto radiusWithout = [&](double tip) {
        return 1.0 / ((1.0 / scene.belief.tipRadius()) + curvature / (1.0 - (tip * curvature)));
    };
    const auto share = [&] {
        return relative(budgetsAt(scene, kMiddle, 2e-9), Landmark::AdhesionForce,
                        UncertaintyInput::ImagingTip);
    };
    const double all = 1.0 - (radiusWithout(kImaging) / radiusWithout(0.0));
    EXPECT_GT(all, 0.04);
    EXPECT_NEAR(share(), all, 0.03 * all) << "nothing was taken out of it";
    scene.description.sample.erode = true;
    const double tenth = 0.1 * kImaging;
    const double half = 0.5 * (radiusWithout(-tenth) - radiusWithout(tenth)) / radiusWithout(0.0);
    EXPECT_NEAR(share(), half, 0.03 * half);
    scene.description.sample.imagingTipRadius = 0.0;
    EXPECT_EQ(share(), 0.0) << "none is known";
}

/// Heights with noise, whose curvature the smoothing and the pitch let through.
TEST(PlaceBudgets, NoiseOfHeightsGoesThroughTheCurvature) {
    SceneDescription description = softScene();
    description.uncertainty.heightNoise = 10e-12;
    const Scene rough = buildScene(description, test::flatMap());
    description.sample.smoothingPixels = 2.0;
    const Scene smooth = buildScene(description, test::flatMap());
    const double unsmoothed = relative(budgetsAt(rough, kMiddle, 2e-9), Landmark::AdhesionForce,
                                       UncertaintyInput::HeightNoise);
    const double smoothed = relative(budgetsAt(smooth, kMiddle, 2e-9), Landmark::AdhesionForce,
                                     UncertaintyInput::HeightNoise);
    // In the continuum a Gaussian of s pixels leaves of each second derivative
    // sqrt(3 / pi) / (4 s^3) = 0.0305 (s = 2) of the noise over the square of the pitch, of
    // both together, with their correlation of 1/3, sqrt(8/3) of it; R_eff takes half of their sum.
    const double curvature = 10e-12 / 4e-18 * 0.03054;
    EXPECT_NEAR(smoothed, 0.5 * 15e-9 * curvature * std::sqrt(8.0 / 3.0), 0.05 * smoothed);
    EXPECT_GT(unsmoothed, 8.0 * smoothed);
}

/// A bump 15 nm wide looks blunter through a wide low-pass; the budget says by how much.
TEST(PlaceBudgets, SmoothingThatMovesTheResultIsNamed) {
    SceneDescription description = softScene();
    HeightMap map = test::flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column - 31.5) * map.pitchX;
            const double y = (row - 31.5) * map.pitchY;
            map.heights[map.index(row, column)] = 8e-9 * std::exp(-((x * x) + (y * y)) / 450e-18);
        }
    }
    const Scene sharp = buildScene(description, map);
    description.sample.smoothingPixels = 3.0;
    const Scene blurred = buildScene(description, map);
    const Budget truth = budgetOf(budgetsAt(sharp, kMiddle, 2e-9), Landmark::AdhesionForce);
    const Budget budget = budgetOf(budgetsAt(blurred, kMiddle, 2e-9), Landmark::AdhesionForce);
    const double moved = std::abs(budget.value - truth.value);
    EXPECT_GT(moved, 0.05 * truth.value);
    EXPECT_NEAR(budget.share(UncertaintyInput::Smoothing), moved, 0.35 * moved) << "first order";
    EXPECT_GT(budget.resolutionShare(), 0.05);
    EXPECT_EQ(truth.share(UncertaintyInput::Smoothing), 0.0);
}

TEST(PlaceBudgets, AnExactShapeHasNoShareOfHeights) {
    SceneDescription description = softScene();
    description.sample.shape = ShapeDescription{};
    const Scene scene = buildScene(description);
    const PlaceBudgets budgets = budgetsAt(scene, {50e-9, 50e-9}, 2e-9);
    const Budget& pull = budgetOf(budgets, Landmark::AdhesionForce);
    EXPECT_EQ(pull.share(UncertaintyInput::HeightNoise), 0.0);
    EXPECT_EQ(pull.share(UncertaintyInput::HeightCalibration), 0.0);
    EXPECT_GT(pull.share(UncertaintyInput::WorkOfAdhesion), 0.0);
}

}  // namespace
}  // namespace asperity
