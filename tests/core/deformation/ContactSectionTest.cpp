#include "core/Units.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/ContactDeformation.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

constexpr SectionPlane kPlane{.azimuth = 0.0, .halfWidth = 20e-9, .tipHeight = 30e-9};

Scene hertzOn(const HeightMap& map) {
    SceneDescription description = test::plainScene();
    description.choices.law = ContactLaw::Hertz;
    return buildScene(description, map);
}

TipState pressed(const Scene& scene, const Vector2& position = {64.0_nm, 64.0_nm}) {
    EquilibriumMemory memory;
    const double z = scene.surface.at(position.x(), position.y()).height - 2.0_nm;
    return tipEquilibrium(scene.surface, scene.belief,
                          {.position = {position.x(), position.y(), z}}, memory);
}

TEST(ContactSection, OfAFlatSampleIsTheContactLawsOwn) {
    const Scene scene = hertzOn(test::flatMap());
    const TipState state = pressed(scene);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    const ContactSection section = contactSection(scene, deformation, kPlane);
    const double share = shareOfSample(scene, state, DeformationModel::ClosedForm);
    ASSERT_EQ(section.rest.size(), 401U);
    for (std::size_t i = 0; i < section.rest.size(); ++i) {
        EXPECT_NEAR(section.rest[i].y(), 0.0, 1e-18);
        const double expected =
            -share * surfaceDisplacement(contactModelAt(scene, state), state.contact,
                                         std::abs(section.rest[i].x()));
        EXPECT_NEAR(section.deformed[i].y(), expected, 1e-13);
        EXPECT_NEAR(section.deformed[i].x(), section.rest[i].x(), 1e-18);
    }
    ASSERT_TRUE(section.rim);
    EXPECT_NEAR((*section.rim)[0].x(), -state.contact.contactRadius, 1e-15);
    EXPECT_NEAR((*section.rim)[1].x(), state.contact.contactRadius, 1e-15);
}

/// The marks were too far apart, by one over the cosine of the slope.
TEST(ContactSection, TheContactOnASlopeIsAsWideAsItsRadiusSays) {
    const Scene scene = hertzOn(test::slopedMap(1.0));
    const TipState state = pressed(scene);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    for (const double azimuth : {0.0, 0.5}) {
        SectionPlane plane = kPlane;
        plane.azimuth = azimuth;
        const ContactSection section = contactSection(scene, deformation, plane);
        ASSERT_TRUE(section.rim);
        const double width = ((*section.rim)[1] - (*section.rim)[0]).norm();
        EXPECT_NEAR(width, 2.0 * state.contact.contactRadius, 0.02 * width) << azimuth;
    }
}

TEST(ContactSection, TipAndSampleTouchInTheMiddle) {
    const Scene scene = hertzOn(test::flatMap());
    const TipState state = pressed(scene);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    const ContactSection section = contactSection(scene, deformation, kPlane);
    const auto lowest = *std::ranges::min_element(
        section.tip, [](const Vector2& one, const Vector2& other) { return one.y() < other.y(); });
    EXPECT_NEAR(lowest.x(), 0.0, 1e-12);
    EXPECT_NEAR(lowest.y(), section.contact.y(), 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(section.tip, {}, [](const Vector2& p) { return p.x(); }));
    EXPECT_NEAR(section.tip.front().y() - state.tip.z(), kPlane.tipHeight, 0.1_nm);
}

TEST(ContactSection, TipIsASphereWithAShankThatGoesOnSmoothly) {
    const Scene scene = hertzOn(test::flatMap());
    EquilibriumMemory memory;
    const TipState state = tipEquilibrium(scene.surface, scene.belief,
                                          {.position = {64.0_nm, 64.0_nm, 50.0_nm}}, memory);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    const ContactSection section = contactSection(scene, deformation, kPlane);
    const double radius = scene.belief.tipRadius();
    for (const Vector2& point : section.tip) {
        const double fromCenter = (point - Vector2(0.0, state.tip.z() + radius)).norm();
        const bool isShank =
            point.y() - state.tip.z() > radius * (1.0 - std::sin(kShankHalfAngle)) + 1e-15;
        EXPECT_TRUE(isShank || std::abs(fromCenter - radius) < 1e-14) << point.transpose();
    }
    const Vector2 shank = section.tip[1] - section.tip[0];
    EXPECT_NEAR(std::atan2(shank.x(), -shank.y()), kShankHalfAngle, 1e-9);
    EXPECT_FALSE(section.rim);
}

TEST(ContactSection, TipHasTheConeOfTheScene) {
    constexpr double kHalfAngle = 0.6;
    SceneDescription description = test::plainScene();
    description.tip.coneHalfAngle = kHalfAngle;
    const Scene scene = buildScene(description, test::flatMap());
    EquilibriumMemory memory;
    const TipState state = tipEquilibrium(scene.surface, scene.belief,
                                          {.position = {64.0_nm, 64.0_nm, 50.0_nm}}, memory);
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    const RoundTip tip = description.tip.shape();
    for (const Vector2& point : contactSection(scene, deformation, kPlane).tip) {
        EXPECT_NEAR(point.y() - state.tip.z(), tip.height(std::abs(point.x())), 1e-14);
    }
}

TEST(ContactSection, LiesInItsPlaneAndEndsAtTheScansEdge) {
    const Scene scene = hertzOn(test::slopedMap(0.2));
    const TipState state = pressed(scene, {120.0_nm, 64.0_nm});
    const ContactDeformation deformation(scene, state, DeformationModel::ClosedForm);
    SectionPlane plane = kPlane;
    const ContactSection alongX = contactSection(scene, deformation, plane);
    EXPECT_LT(alongX.rest.back().x(), 8.5_nm);
    EXPECT_NEAR(alongX.rest.front().x(), -20.0_nm, 0.5_nm);
    const double slope = (alongX.rest.back().y() - alongX.rest.front().y()) /
                         (alongX.rest.back().x() - alongX.rest.front().x());
    EXPECT_NEAR(slope, 0.2, 1e-6);
    plane.azimuth = std::numbers::pi / 2.0;
    const ContactSection alongY = contactSection(scene, deformation, plane);
    EXPECT_NEAR(alongY.rest.front().y(), alongY.rest.back().y(), 1e-14) << "level along y";
    EXPECT_NEAR(alongY.positionAt(3.0_nm).y(), alongY.axis.y() + 3.0_nm, 1e-20);
}

}  // namespace
}  // namespace asperity
