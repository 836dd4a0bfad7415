#include "core/Units.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

Scene sceneOf(ContactLaw law, DeformationModel model = DeformationModel::ClosedForm) {
    SceneDescription description = test::plainScene();
    description.choices.law = law;
    description.choices.deformation = model;
    return buildScene(description, test::flatMap());
}

TipState stateAt(const Scene& scene, double height) {
    EquilibriumMemory memory;
    TipState state;
    for (double z = 3.0_nm; z > height; z -= 0.1_nm) {
        state = tipEquilibrium(scene.surface, scene.belief, {.position = {64.0_nm, 64.0_nm, z}},
                               memory);
    }
    return tipEquilibrium(scene.surface, scene.belief, {.position = {64.0_nm, 64.0_nm, height}},
                          memory);
}

/// At a distance from the contact's axis on the flat sample; the lever's tilt moves it sideways.
Vector3 positionAt(const TipState& state, double distance) {
    return state.closest.point + distance * Vector3(0.6, 0.8, 0.0);
}

TEST(ContactField, PressureOfHertzIsAHalfEllipseAndAddsUpToTheForce) {
    const Scene scene = sceneOf(ContactLaw::Hertz);
    const TipState state = stateAt(scene, -2.0_nm);
    const ContactField field(scene, state);
    const double a = state.contact.contactRadius;
    const double middle = 1.5 * state.contact.force / (std::numbers::pi * a * a);
    double force = 0.0;
    constexpr int kRings = 2000;
    for (int ring = 0; ring < kRings; ++ring) {
        const double r = a * (ring + 0.5) / kRings;
        const double expected = middle * std::sqrt(1.0 - r * r / (a * a));
        EXPECT_NEAR(field.pressure(positionAt(state, r)), expected, 1e-6 * middle);
        force += field.pressure(positionAt(state, r)) * 2.0 * std::numbers::pi * r * a / kRings;
    }
    EXPECT_NEAR(force, state.contact.force, 1e-4 * state.contact.force);
    EXPECT_EQ(field.pressure(positionAt(state, 1.01 * a)), 0.0);
    EXPECT_FALSE(field.isHalfSpace());
}

TEST(ContactField, PressureOfMaugisPullsInTheCohesiveZone) {
    const Scene scene = sceneOf(ContactLaw::Maugis);
    const TipState state = stateAt(scene, -1.0_nm);
    const ContactField field(scene, state);
    const double zone = 0.5 * (state.contact.contactRadius + state.contact.cohesiveRadius);
    EXPECT_EQ(field.pressure(positionAt(state, zone)),
              -contactModelAt(scene, state).cohesiveStress());
    EXPECT_GT(field.pressure(positionAt(state, 0.0)), 0.0);
}

TEST(ContactField, GapOnAFlatSampleIsThatOfTheLaw) {
    for (const ContactLaw law : {ContactLaw::Hertz, ContactLaw::Maugis, ContactLaw::SphereMaugis}) {
        const Scene scene = sceneOf(law);
        for (const double height : {2.0_nm, -1.5_nm}) {
            const TipState state = stateAt(scene, height);
            const ContactField field(scene, state);
            const ContactModel model = contactModelAt(scene, state);
            const CohesiveContact profile = contactProfile(model, state.contact);
            for (const double r : {0.0_nm, 0.5_nm, 2.0_nm, 5.0_nm, 12.0_nm}) {
                const double total = surfaceDisplacement(model, state.contact, r);
                const double gap = field.gap(positionAt(state, r), 0.4 * total, 0.6 * total);
                EXPECT_NEAR(gap, std::max(0.0, surfaceGap(profile, r)), 1e-14)
                    << nameOf(law) << " at " << height << ", r " << r;
            }
        }
    }
}

TEST(ContactField, GapIsNotDefinedBesideTheTip) {
    const Scene scene = sceneOf(ContactLaw::SphereMaugis);
    const TipState state = stateAt(scene, 2.0_nm);
    const ContactField field(scene, state);
    EXPECT_NEAR(field.gap(positionAt(state, 0.0), 0.0, 0.0), 2.0_nm, 0.2_nm);
    EXPECT_TRUE(
        std::isfinite(field.gap(positionAt(state, 0.99 * scene.belief.tipRadius()), 0.0, 0.0)));
    EXPECT_TRUE(
        std::isnan(field.gap(positionAt(state, 1.01 * scene.belief.tipRadius()), 0.0, 0.0)));
}

TEST(ContactField, PressureIsTheHalfSpacesWhereThatIsShown) {
    const Scene scene = sceneOf(ContactLaw::Maugis, DeformationModel::HalfSpace);
    const TipState state = stateAt(scene, -0.5_nm);
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    ASSERT_TRUE(answer.valid()) << nameOf(answer.verdict);
    const ContactField field(scene, state, &answer);
    EXPECT_TRUE(field.isHalfSpace());
    const ContactField law(scene, state);
    const double middle = law.pressure(positionAt(state, 0.0));
    EXPECT_NEAR(field.pressure(positionAt(state, 0.0)), middle, 0.05 * middle) << "a flat sample";
    double force = 0.0;
    const double step = 0.05_nm;
    for (double x = 34.0_nm; x < 94.0_nm; x += step) {
        for (double y = 34.0_nm; y < 94.0_nm; y += step) {
            force += field.pressure({x, y, 0.0}) * step * step;
        }
    }
    EXPECT_NEAR(force, answer.force, 0.02 * std::abs(answer.force) + 0.02e-9);
    EXPECT_EQ(field.pressure(positionAt(state, 60.0_nm)), 0.0);
}

TEST(ContactField, TakesNoPressureFromAnAnswerOfAnotherContact) {
    const Scene scene = sceneOf(ContactLaw::Maugis, DeformationModel::HalfSpace);
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, stateAt(scene, -0.5_nm));
    EXPECT_FALSE(ContactField(scene, stateAt(scene, -3.0_nm), &answer).isHalfSpace());
}

}  // namespace
}  // namespace asperity
