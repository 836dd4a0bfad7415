#include "core/Units.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "tests/ui/view/WindowAround.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/ViewFrame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace asperity {

namespace {

using test::windowAround;

/// So soft that the contact is wider than the tip.
Scene rubberScene(std::optional<ContactLaw> law = ContactLaw::Split) {
    HeightMap map = test::flatMap();
    map.pitchX *= 3.0;
    map.pitchY *= 3.0;
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = {.youngsModulus = 1e6, .poissonRatio = 0.5};
    description.sample.material.workOfAdhesion = 0.022;
    description.choices.law = law;
    return buildScene(description, map);
}

/// From the contact's axis, of a sample of the surface at rest [m].
double distanceOf(const ContactShape& shape, std::size_t index) {
    return (shape.patch().rest[index] - shape.contact().closest).head<2>().norm();
}

/// Largest displacement among the samples from a distance on [m].
double largestBeyond(const ContactShape& shape, double distance) {
    double largest = 0.0;
    for (std::size_t i = 0; i < shape.displacements().size(); ++i) {
        if (distanceOf(shape, i) > distance) {
            largest = std::max(largest, std::abs(shape.displacements()[i]));
        }
    }
    return largest;
}

/// Farthest that a sample in contact, its rounded rim aside, is drawn from the paraboloid that
/// stands for the tip [m].
double farthestFromTip(const ContactShape& shape) {
    const TipContact& contact = shape.contact();
    double farthest = 0.0;
    for (std::size_t i = 0; i < shape.displacements().size(); ++i) {
        const double r = distanceOf(shape, i);
        if (r < 0.8 * contact.contactRadius) {
            const double tip = contact.indentation - r * r / (2.0 * contact.tipRadius);
            farthest = std::max(farthest, std::abs(shape.displacements()[i] - tip));
        }
    }
    return farthest;
}

}  // namespace

TEST(ViewScale, OfAStiffSampleIsThatOfTheTip) {
    const Scene scene = test::flatScene();
    const ViewScale scale = viewScale(scene);
    const double radius = scene.belief.tipRadius();
    EXPECT_NEAR(unloadedContactRadius(scene.belief.contact.pair()), 0.3 * radius, 0.02 * radius);
    EXPECT_DOUBLE_EQ(scale.patch, 2.0 * radius);
    EXPECT_DOUBLE_EQ(scale.usual, 2.4 * radius);
    EXPECT_DOUBLE_EQ(scale.least, 1.25 * radius);
}

TEST(ViewScale, IsThatOfTheContactWhereItIsWide) {
    const Scene scene = rubberScene();
    const ViewScale scale = viewScale(scene);
    const double unloaded = unloadedContactRadius(scene.belief.contact.pair());
    EXPECT_NEAR(unloaded, 37.4_nm, 0.5_nm);
    EXPECT_DOUBLE_EQ(scale.patch, 2.5 * unloaded);
    EXPECT_DOUBLE_EQ(scale.usual, 3.2 * unloaded);
    EXPECT_LT(scale.least, scale.usual);
}

TEST(ViewScale, OnTheExactSphereNoContactIsWiderThanTheTip) {
    const Scene scene = rubberScene(std::nullopt);
    ASSERT_EQ(scene.belief.contact.law(), ContactLaw::SphereSplit);
    EXPECT_DOUBLE_EQ(viewScale(scene).patch, 2.5 * scene.belief.tipRadius());
}

TEST(ViewScale, HasRoomForAConeAtTheSetpoint) {
    SceneDescription description = rubberScene(std::nullopt).description;
    description.tip.coneHalfAngle = 0.3;
    description.setpoint = 20.0_nN;
    const Scene scene = buildScene(description, test::flatMap());
    const ContactModel& model = scene.belief.contact;
    const double shown = viewScale(scene).patch / 2.5;
    ASSERT_GT(shown, scene.belief.tipRadius());
    // Elastic cone: P = (pi/2) E* a^2 cot(alpha), and adhesion, which presses it farther in.
    const double elastic =
        std::sqrt(20.0_nN * std::tan(0.3) * 2.0 / std::numbers::pi / model.pair().reducedModulus);
    EXPECT_GT(shown, elastic);
    EXPECT_LT(shown, 1.5 * elastic);
}

TEST(ViewScale, OpensAtAWidthOfThirtyPixels) {
    HeightMap map = test::flatMap();
    map.pitchX *= 4.0;
    map.pitchY *= 3.0;
    const ViewScale scale = viewScale(buildScene(test::plainScene(), map));
    EXPECT_DOUBLE_EQ(scale.pixel, 8.0_nm);
    EXPECT_DOUBLE_EQ(2.0 * scale.usual, 30.0 * scale.pixel);
}

TEST(ViewScale, DrawsAParaboloidForALawOfParaboloidsWhereTheContactIsWide) {
    EXPECT_EQ(viewScale(test::flatScene()).paraboloidReach, 0.0) << "a small contact";
    EXPECT_GT(viewScale(rubberScene()).paraboloidReach, 37.4_nm);
    EXPECT_EQ(viewScale(rubberScene(std::nullopt)).paraboloidReach, 0.0) << "the exact sphere";
}

TEST(ViewScale, AGivenWidthOfTheFrameIsKept) {
    Scene scene = rubberScene();
    scene.description.zoomHalfWidth = 50.0_nm;
    EXPECT_DOUBLE_EQ(viewScale(scene).usual, 50.0_nm);
}

/// A tip of 2 um on a scan of 128 nm: what bears is an asperity.
TEST(ViewScale, OfATipLargerThanTheScanIsThatOfTheAsperityThatItMeets) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 2.0_um;
    const Scene hilly = buildScene(description, test::hillyMap());
    const ViewScale scale = viewScale(hilly);
    const double scan = 0.5 * hilly.surface.sizeX();
    EXPECT_LT(scale.usual, 0.7 * scan);
    EXPECT_LT(scale.section, 0.7 * scan);
    EXPECT_LE(scale.least, scale.usual);
    EXPECT_LT(scale.leastSection, 0.1 * scale.section);
    // No asperity: the contact is as wide as the view.
    const Scene flat = buildScene(description, test::flatMap());
    EXPECT_GT(viewScale(flat).usual, 0.5 * flat.surface.sizeX());
    EXPECT_DOUBLE_EQ(viewScale(flat).section, 0.5 * flat.surface.sizeX()) << "not 8 um";
}

/// The arrow of the setpoint and that of the pull-off are both seen, whatever the tip.
TEST(ViewScale, TheUsualForceIsBetweenSetpointAndPullOff) {
    for (const double radius : {15.0_nm, 2.0_um}) {
        SceneDescription description = test::plainScene();
        description.tip.radius = radius;
        const Scene scene = buildScene(description, test::flatMap());
        const double pullOff =
            1.5 * std::numbers::pi * radius * scene.belief.contact.pair().workOfAdhesion;
        const double usual = viewScale(scene).force;
        for (const double force : {scene.description.setpoint, pullOff}) {
            EXPECT_GT(arrowLength(force, usual, 1.0), 0.06) << radius << " " << force;
        }
    }
}

TEST(ViewScale, TheFrameHasRoomForTheShankOfATipAtTheSetpoint) {
    SceneDescription description = rubberScene(std::nullopt).description;
    description.setpoint = 5.0_nN;
    HeightMap map = test::flatMap();
    map.pitchX *= 4.0;
    map.pitchY *= 4.0;
    const ViewScale scale = viewScale(buildScene(description, map));
    ASSERT_GT(scale.dent, 60.0_nm);
    const TipOutline outline{description.tip.shape()};
    EXPECT_GE(scale.usual, 1.5 * outline.radius(scale.dent));
}

TEST(ViewScale, ThePatchHoldsTheWideContactOfRubber) {
    const Scene scene = rubberScene();
    const test::ViewMoments moments = test::momentsOf(scene);
    ASSERT_GT(moments.deep.sample.output.model.contact.contactRadius,
              1.5 * scene.belief.tipRadius());
    for (const Snapshot& moment : {moments.deep, moments.neck}) {
        const TipState& state = moment.sample.output.model;
        const double reach = viewScale(scene).patch;
        const ContactShape shape(scene, state, windowAround(state.tip, reach), 65);
        EXPECT_LT(farthestFromTip(shape), 0.5_nm + shape.tipDisplacement(0.0));
        // Where it goes over into rest, and in the corners, nothing stands out.
        EXPECT_LT(largestBeyond(shape, 0.65 * reach), 0.5 * shape.largestDisplacement());
    }
}

TEST(ViewScale, APatchTooSmallForTheContactHasNoSpikes) {
    const Scene scene = rubberScene();
    const TipState state = test::momentsOf(scene).deep.sample.output.model;
    const double radius = state.contact.contactRadius;
    const double rim =
        radius * radius / (2.0 * scene.belief.tipRadius()) - state.contact.indentation;
    double before = 0.0;
    for (const double room : {0.7, 1.0, 1.2, 1.4, 1.6}) {
        const ContactShape shape(scene, state, windowAround(state.tip, room * radius), 65);
        const double largest = shape.largestDisplacement();
        EXPECT_GE(largest, before) << room;
        EXPECT_LE(largest, rim) << room;
        EXPECT_LE(largestBeyond(shape, room * radius), 0.25 * rim) << "in the corners, " << room;
        before = largest;
    }
    EXPECT_GT(before, 0.6 * rim);
}

}  // namespace asperity
