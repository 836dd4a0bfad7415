#include "core/uncertainty/LandmarkBudgets.h"

#include "core/scene/Scene.h"
#include "core/uncertainty/CycleBudgets.h"
#include "core/uncertainty/FitResponse.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

/// A bump of 8 nm. @param width square of where it has fallen by a factor of e [m^2]
HeightMap bumpMap(double width) {
    HeightMap map = test::flatMap();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const double x = (column - 31.5) * map.pitchX;
            const double y = (row - 31.5) * map.pitchY;
            map.heights[map.index(row, column)] = 8e-9 * std::exp(-((x * x) + (y * y)) / width);
        }
    }
    return map;
}

double relative(const LandmarkBudgets& budgets, Landmark landmark, UncertaintyInput input) {
    const Budget& budget = budgetOf(budgets, landmark);
    return budget.share(input) / budget.value;
}

TEST(LandmarkBudgets, AreThoseOfAClosedForm) {
    const Scene scene = buildScene(softScene(), test::flatMap());
    const LandmarkBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
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
TEST(LandmarkBudgets, AThermalStiffnessGoesWithTheInvOls) {
    SceneDescription description = softScene();
    description.uncertainty.thermalStiffness = true;
    const Scene scene = buildScene(description, test::flatMap());
    const LandmarkBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
    EXPECT_NEAR(relative(budgets, Landmark::NormalForce, UncertaintyInput::InvOls), 0.03, 5e-4);
    EXPECT_NEAR(relative(budgets, Landmark::NormalForce, UncertaintyInput::Stiffness), 0.08, 4e-3);
}

TEST(LandmarkBudgets, AreOffOnRequest) {
    SceneDescription description = softScene();
    description.uncertainty.enabled = false;
    const Scene scene = buildScene(description, test::hillyMap());
    for (const Budget& budget : budgetsAt(scene, kMiddle, 2e-9)) {
        EXPECT_EQ(budget.model(), 0.0);
        EXPECT_GE(budget.value, 0.0);
    }
}

/// Without a position: what a flat sample says but for the turn of its normal.
TEST(LandmarkBudgets, OfALawAreThoseOfAFlatSample) {
    SceneDescription description = softScene();
    description.sample.shape = ShapeDescription{.kind = ShapeKind::Plane};
    description.uncertainty.surfaceNormal = 0.0;
    const Scene scene = buildScene(description);
    const LandmarkBudgets ofPosition = budgetsAt(scene, {50e-9, 50e-9}, 2e-9);
    const LandmarkBudgets ofLaw = budgetsOf(description, scene.belief.contact,
                                            scene.belief.cantilever.compliance()(2, 2), 2e-9);
    for (const LandmarkRow& row : kEnumTable<Landmark>) {
        const Budget& expected = budgetOf(ofPosition, row.value);
        const Budget& found = budgetOf(ofLaw, row.value);
        EXPECT_NEAR(found.value, expected.value, 1e-9 * expected.value) << row.key;
        EXPECT_NEAR(found.model(), expected.model(), 1e-6 * expected.model()) << row.key;
    }
}

/// Under JKR the pull-off goes as the effective radius, here that of a bump without its imaging
/// tip.
class ImagedBump : public ::testing::Test {
protected:
    static constexpr double kImaging = 10e-9;  // [m]

    ImagedBump() { description.sample.imagingTipRadius = kImaging; }

    [[nodiscard]] Scene scene(bool erode) const {
        SceneDescription eroded = description;
        eroded.sample.erode = erode;
        return buildScene(eroded, bumpMap(900e-18));
    }
    /// Of the scan as it was recorded [1/m].
    [[nodiscard]] double curvature() const {
        const HeightSample top = scene(false).surface.at(kMiddle.x(), kMiddle.y());
        return -0.5 * (top.dxx + top.dyy);
    }
    [[nodiscard]] double radiusAt(double bend, double tip) const {
        return 1.0 / ((1.0 / description.tip.radius) + bend / (1.0 - (tip * bend)));
    }

    SceneDescription description = softScene();
};

TEST_F(ImagedBump, KeepsAShiftWhereItIsNotEroded) {
    const Scene shown = scene(false);
    const Budget pull = budgetOf(budgetsAt(shown, kMiddle, 2e-9), Landmark::AdhesionForce);
    const double all = 1.0 - (radiusAt(curvature(), kImaging) / radiusAt(curvature(), 0.0));
    EXPECT_GT(all, 0.04);
    EXPECT_NEAR(pull.shift / pull.value, all, 0.03 * all);
    EXPECT_LT(pull.share(UncertaintyInput::ImagingTip), 0.5 * pull.shift);
    const Budget eroded = budgetOf(budgetsAt(scene(true), kMiddle, 2e-9), Landmark::AdhesionForce);
    EXPECT_EQ(eroded.shift, 0.0);
    Scene unknown = shown;
    unknown.description.sample.imagingTipRadius = 0.0;
    const Budget ofScan = budgetOf(budgetsAt(unknown, kMiddle, 2e-9), Landmark::AdhesionForce);
    EXPECT_EQ(ofScan.shift, 0.0) << "none is known";
    EXPECT_EQ(ofScan.share(UncertaintyInput::ImagingTip), 0.0);
    Scene off = shown;
    off.description.uncertainty.enabled = false;
    EXPECT_EQ(budgetOf(budgetsAt(off, kMiddle, 2e-9), Landmark::AdhesionForce).shift, 0.0);
}

TEST_F(ImagedBump, LeavesTheDeviationOfItsTip) {
    const double bend = curvature();
    const double half = 0.5 * (radiusAt(bend, kImaging / 1.1) - radiusAt(bend, 1.1 * kImaging));
    for (const bool erode : {false, true}) {
        const Budget pull =
            budgetOf(budgetsAt(scene(erode), kMiddle, 2e-9), Landmark::AdhesionForce);
        const double expected = half / radiusAt(bend, erode ? kImaging : 0.0);
        EXPECT_NEAR(pull.share(UncertaintyInput::ImagingTip) / pull.value, expected,
                    0.05 * expected)
            << erode;
    }
}

/// The low-pass acted on what was recorded; erosion makes more of it. Read off the surface behind
/// the erosion, whose search goes from pixel to pixel, it would be a multiple.
TEST_F(ImagedBump, WasSmoothedBeforeItWasEroded) {
    description.sample.smoothingPixels = 2.0;
    const double bend = curvature();
    constexpr double kPitch = 2e-9;  // [m]
    const Scene recorded = scene(false);
    const FitResponse response(RecordedScan(recorded.surface), {2.0, 2.0}, kMiddle.x(),
                               kMiddle.y());
    const double variance = 4.0 * kPitch * kPitch;
    const Relief sharpening = response.sharpening({variance, variance});
    const double sharper = bend - (0.5 * (sharpening[2] + sharpening[4]));
    const double radius = radiusAt(bend, kImaging);
    const double expected = (radius - radiusAt(sharper, kImaging)) / radius;
    const double share = relative(budgetsAt(scene(true), kMiddle, 2e-9), Landmark::AdhesionForce,
                                  UncertaintyInput::Smoothing);
    EXPECT_GT(expected, 0.005);
    EXPECT_NEAR(share, expected, 0.3 * expected) << "a fourth derivative between wide pixels";
}

/// The law's pull-off does not depend on the lever; a reading of its signals does.
TEST(LandmarkBudgets, OfReadingsHoldTheLever) {
    const Scene scene = buildScene(softScene(), test::flatMap());
    const LandmarkBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
    ContactCycle cycle{.phase = CyclePhase::Complete};
    cycle.pullOff = Reading{5e-9, 0.1e-9};
    cycle.adhesionWork = 1e-18;
    for (const char* key : {"pull_off_force_n", "adhesion_work_j"}) {
        const std::optional<Budget> read = budgetNamed(cycleBudgets(budgets, cycle), key);
        ASSERT_TRUE(read) << key;
        EXPECT_GE(read->share(UncertaintyInput::Stiffness), 0.095 * read->value) << key;
        EXPECT_GE(read->share(UncertaintyInput::InvOls), 0.029 * read->value) << key;
    }
    EXPECT_NEAR(relative(budgets, Landmark::AdhesionForce, UncertaintyInput::Stiffness), 0.0, 1e-6);
}

/// A reading does not go where the law at the position has nothing like it: all of a colloid's did.
TEST(LandmarkBudgets, WithoutALandmarkLeaveAReadingItsNoise) {
    LandmarkBudgets budgets = budgetsAt(buildScene(softScene(), test::flatMap()), kMiddle, 2e-9);
    budgets[static_cast<std::size_t>(Landmark::AdhesionForce)].value =
        std::numeric_limits<double>::quiet_NaN();
    ContactCycle cycle{.phase = CyclePhase::Complete};
    cycle.pullOff = Reading{5e-9, 0.1e-9};
    cycle.maxForce = {2e-9, 0.1e-9};
    const std::optional<Budget> read =
        budgetNamed(cycleBudgets(budgets, cycle), "pull_off_force_n");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->value, 5e-9);
    EXPECT_EQ(read->noise, 0.1e-9);
    EXPECT_FALSE(read->isModelKnown());
    EXPECT_EQ(read->unknown, UnknownShares::NoLandmark);
    cycle.maxForce = {0.05e-9, 0.1e-9};
    EXPECT_FALSE(budgetNamed(cycleBudgets(budgets, cycle), "pull_off_force_n")) << "of noise alone";
}

/// What the output says of its model's error is in each deviation.
TEST(LandmarkBudgets, HoldTheErrorOfTheModel) {
    SceneDescription description = test::plainScene();
    Scene scene = buildScene(description, test::flatMap());
    const LandmarkBudgets before = budgetsAt(scene, kMiddle, 2e-9);
    EXPECT_FALSE(budgetOf(before, Landmark::AdhesionForce).isLeftOutKnown()) << "not judged yet";
    EXPECT_TRUE(budgetOf(before, Landmark::NormalForce).isLeftOutKnown());
    scene.leftOut.emplace();
    (*scene.leftOut)[JudgedQuantity::PullOffForce] = 1.16;
    (*scene.leftOut)[JudgedQuantity::SnapInPosition] = 0.02;
    const LandmarkBudgets budgets = budgetsAt(scene, kMiddle, 2e-9);
    const Budget& pull = budgetOf(budgets, Landmark::AdhesionForce);
    EXPECT_NEAR(pull.leftOut, 1.16 * pull.value, 1e-9 * pull.value);
    EXPECT_NEAR(pull.model(),
                std::hypot(1.16 * pull.value, budgetOf(before, Landmark::AdhesionForce).model()),
                1e-9 * pull.value);
    EXPECT_NEAR(budgetOf(budgets, Landmark::SnapInDistance).leftOut,
                0.02 * budgetOf(budgets, Landmark::ContactTravel).value, 1e-18);
    EXPECT_EQ(budgetOf(budgets, Landmark::NormalForce).leftOut, 0.0) << "the lever says it";
    setModel(scene, scene.model);
    EXPECT_FALSE(scene.leftOut) << "of another model";
}

/// The law is of one contact: of several only the force that the lever holds is known, and what
/// terms left out do.
TEST(LandmarkBudgets, AreNotKnownOfSeveralContacts) {
    Scene scene = buildScene(softScene(), test::flatMap());
    scene.leftOut.emplace();
    (*scene.leftOut)[JudgedQuantity::PullOffForce] = 27.0;
    const BaseMotion tip{.position = Vector3(kMiddle.x(), kMiddle.y(), 0.0)};
    TipState state = heldTip(scene.believedSurface(), scene.belief, tip, {});
    state.points = 2;
    const LandmarkBudgets budgets = budgetsAt(scene, state, 2e-9);
    EXPECT_FALSE(budgetOf(budgets, Landmark::AdhesionForce).isModelKnown());
    EXPECT_FALSE(budgetOf(budgets, Landmark::Indentation).isModelKnown());
    const Budget& adhesion = budgetOf(budgets, Landmark::AdhesionForce);
    EXPECT_EQ(adhesion.unknown, UnknownShares::SeveralContacts);
    EXPECT_NEAR(adhesion.leftOut, 27.0 * adhesion.value, 1e-9 * adhesion.value);
    EXPECT_NEAR(relative(budgets, Landmark::NormalForce, UncertaintyInput::Stiffness), 0.1, 5e-3);

    const LandmarkBudgets ofOne = budgetsAt(scene, kMiddle, 2e-9);
    ContactCycle cycle{.phase = CyclePhase::Complete};
    cycle.pullOff = Reading{5e-9, 0.1e-9};
    cycle.maxForce = {2e-9, 0.1e-9};
    const auto knows = [&](const char* key) {
        return budgetNamed(cycleBudgets(ofOne, cycle), key).value().isModelKnown();
    };
    const auto unknown = [&] {
        return budgetNamed(cycleBudgets(ofOne, cycle), "pull_off_force_n").value().unknown;
    };
    cycle.contacts = 1;
    EXPECT_TRUE(knows("pull_off_force_n"));
    cycle.contacts = 2;
    EXPECT_FALSE(knows("pull_off_force_n"));
    EXPECT_EQ(unknown(), UnknownShares::SeveralContacts);
    EXPECT_TRUE(knows("max_force_n"));
    cycle.contacts = 1;
    cycle.interrupted = true;
    EXPECT_FALSE(knows("pull_off_force_n"));
    EXPECT_EQ(unknown(), UnknownShares::MissingTicks);
}

/// A blunt tip above the foot of a bump touches the bump: at its apex it would be deep in it.
TEST(LandmarkBudgets, AreOfWhatTheTipTouches) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 2e-6;
    description.choices.bodyAttraction = true;
    const Scene scene = buildScene(description, bumpMap(640e-18));
    const Budget onTop = budgetOf(budgetsAt(scene, kMiddle, 2e-9), Landmark::AdhesionForce);
    const LandmarkBudgets beside = budgetsAt(scene, kMiddle + Vector2(30e-9, 0.0), 2e-9);
    const Budget& pull = budgetOf(beside, Landmark::AdhesionForce);
    EXPECT_NEAR(pull.value, onTop.value, 0.02 * onTop.value);
    EXPECT_NEAR(pull.share(UncertaintyInput::WorkOfAdhesion), 0.1 * pull.value, 0.01 * pull.value);
    EXPECT_NEAR(relative(beside, Landmark::NormalForce, UncertaintyInput::Stiffness), 0.1, 5e-3);
}

/// A sharp asperity's law hardly depends on how blunt the tip is; what attracts beside it goes as
/// the tip's radius.
TEST(LandmarkBudgets, HoldTheAttractionBesideTheContact) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 20e-6;
    description.sample.material.friction = {};
    const auto pullWith = [&description](bool beside) {
        description.choices.bodyAttraction = beside;
        const Scene scene = buildScene(description, bumpMap(640e-18));
        return budgetOf(budgetsAt(scene, kMiddle, 2e-9), Landmark::AdhesionForce);
    };
    const Budget alone = pullWith(false);
    const Budget both = pullWith(true);
    const double beside = both.value - alone.value;
    EXPECT_GT(beside, 0.1 * alone.value);
    EXPECT_LT(alone.share(UncertaintyInput::TipRadius), 0.002 * alone.value);
    for (const UncertaintyInput input :
         {UncertaintyInput::TipRadius, UncertaintyInput::WorkOfAdhesion}) {
        EXPECT_NEAR(both.share(input) - alone.share(input), 0.1 * beside, 0.02 * beside);
    }
}

/// Heights with noise, whose curvature the smoothing and the pitch let through.
TEST(LandmarkBudgets, NoiseOfHeightsGoesThroughTheCurvature) {
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
TEST(LandmarkBudgets, SmoothingThatMovesTheResultIsNamed) {
    SceneDescription description = softScene();
    const HeightMap map = bumpMap(450e-18);
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

/// Flat ground without noise has nothing to hide. With noise, what a low-pass took of a rougher one
/// could not be told from it.
TEST(LandmarkBudgets, NoiseSaysWhatRoughnessItHides) {
    SceneDescription description = softScene();
    description.sample.smoothingPixels = 2.0;
    const auto pullOff = [&] {
        const Scene scene = buildScene(description, test::flatMap());
        return budgetOf(budgetsAt(scene, kMiddle, 2e-9), Landmark::AdhesionForce);
    };
    EXPECT_EQ(pullOff().hidden, 0.0);
    description.uncertainty.heightNoise = 30e-12;
    const Budget noisy = pullOff();
    EXPECT_EQ(noisy.share(UncertaintyInput::Smoothing), 0.0);
    EXPECT_GT(noisy.hidden, 0.3 * noisy.share(UncertaintyInput::HeightNoise));
    EXPECT_DOUBLE_EQ(noisy.of(0.5 * noisy.value, 0.0).hidden, 0.5 * noisy.hidden);
}

/// A low-pass that stands out from noise by little takes nothing back of what noise may hide.
TEST(LandmarkBudgets, WhatNoiseHidesDoesNotEndWhereSmoothingStandsOut) {
    SceneDescription description = softScene();
    description.sample.smoothingPixels = 2.0;
    const auto pullOff = [&](double noise) {
        description.uncertainty.heightNoise = noise;
        const Scene scene = buildScene(description, bumpMap(1e-15));
        return budgetOf(budgetsAt(scene, kMiddle, 2e-9), Landmark::AdhesionForce);
    };
    const double moved = pullOff(1e-15).share(UncertaintyInput::Smoothing);
    const double hiddenByUnit = pullOff(1e-12).hidden / 1e-12;
    const Budget below = pullOff(1.05 * moved / hiddenByUnit);
    EXPECT_EQ(below.share(UncertaintyInput::Smoothing), 0.0);
    EXPECT_NEAR(below.hidden, 1.05 * moved, 0.02 * moved);
    const Budget above = pullOff(0.95 * moved / hiddenByUnit);
    EXPECT_GT(above.share(UncertaintyInput::Smoothing), 0.0);
    EXPECT_NEAR(above.hidden, 0.95 * moved, 0.02 * moved);
}

TEST(LandmarkBudgets, AnExactShapeHasNoShareOfHeights) {
    SceneDescription description = softScene();
    description.sample.shape = ShapeDescription{};
    const Scene scene = buildScene(description);
    const LandmarkBudgets budgets = budgetsAt(scene, {50e-9, 50e-9}, 2e-9);
    const Budget& pull = budgetOf(budgets, Landmark::AdhesionForce);
    EXPECT_EQ(pull.share(UncertaintyInput::HeightNoise), 0.0);
    EXPECT_EQ(pull.share(UncertaintyInput::HeightCalibration), 0.0);
    EXPECT_GT(pull.share(UncertaintyInput::WorkOfAdhesion), 0.0);
}

}  // namespace
}  // namespace asperity
