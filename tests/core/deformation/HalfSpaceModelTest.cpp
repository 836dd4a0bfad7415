#include "core/deformation/HalfSpaceModel.h"

#include "core/Units.h"
#include "core/contact/ContactState.h"
#include "core/contact/displacement/SurfaceDisplacement.h"
#include "core/deformation/ContactDeformation.h"
#include "core/scene/Scene.h"
#include "core/surface/TangentFrame.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// A tip pressed on the middle of the scan, so lightly that the half-space holds: the base is
/// lowered from afar until the tip has come this deep.
TipState pressed(const Scene& scene, double indentation, Vector2 position = {64.0_nm, 64.0_nm}) {
    EquilibriumMemory memory;
    TipState state;
    const double surface = scene.surface.at(position.x(), position.y()).height;
    for (int step = 0; step < 1400; ++step) {
        const double height = surface + 8.0_nm - step * 0.02_nm;
        const BaseMotion base{.position = {position.x(), position.y(), height}};
        state = tipEquilibrium(scene.surface, scene.belief, base, memory);
        if (state.contact.contactRadius > 0.0 && state.contact.indentation > indentation) {
            return state;
        }
    }
    ADD_FAILURE() << "never pressed";
    return state;
}

Scene sceneOn(const HeightMap& map, ContactLaw law = ContactLaw::Split) {
    SceneDescription description = test::plainScene();
    description.choices.law = law;
    description.choices.deformation = DeformationModel::HalfSpace;
    return buildScene(description, map);
}

double adhesionUnit(const Scene& scene) {
    const ContactPair& pair = scene.belief.contact.pair();
    return std::numbers::pi * pair.workOfAdhesion * pair.tipRadius;
}

/// What a law's cohesive zone does under the exact sphere, which the half-space takes for the tip.
ContactState onTheSphere(const Scene& scene, const TipState& state) {
    const HalfSpaceContact contact =
        halfSpaceContact(scene, state, {.samples = 4, .halfWidth = 1.0_nm});
    const ContactModel exact(ContactLaw::SphereMaugis,
                             {.tipRadius = contact.tipRadius,
                              .reducedModulus = contact.reducedModulus,
                              .workOfAdhesion = contact.cohesiveStress * contact.cohesiveRange},
                             {.cohesiveStress = contact.cohesiveStress});
    return exact.equilibrium(contact.approach, 0.0, {ContactBranch::Bonded, 0.0});
}

TEST(HalfSpaceModel, AgreesWithTheContactLawOnAFlatSample) {
    for (const ContactLaw law : {ContactLaw::Split, ContactLaw::Maugis, ContactLaw::SphereMaugis,
                                 ContactLaw::SphereSplit}) {
        const Scene scene = sceneOn(test::flatMap(), law);
        const TipState state = pressed(scene, 0.3_nm);
        const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
        ASSERT_TRUE(answer.valid()) << nameOf(answer.verdict);
        const ContactState exact = onTheSphere(scene, state);
        EXPECT_NEAR(answer.force, exact.force + forceBeyondZone(scene, state),
                    0.005 * adhesionUnit(scene));
        EXPECT_NEAR(answer.contactRadius, exact.contactRadius, 0.01 * exact.contactRadius);
        const ContactModel model = contactModelAt(scene, state);
        for (const double r : {0.0, 2.0_nm, 4.0_nm, 6.0_nm, 9.0_nm, 14.0_nm, 25.0_nm}) {
            EXPECT_NEAR(answer.field->at(0.6 * r, 0.8 * r),
                        surfaceDisplacement(model, state.contact, r),
                        0.04 * state.contact.indentation)
                << r;
        }
    }
}

TEST(HalfSpaceModel, IsTheSameOnAnInclinedPlane) {
    const Scene level = sceneOn(test::flatMap());
    const Scene steep = sceneOn(test::slopedMap(0.8));
    const TipState above = pressed(level, 0.3_nm);
    TipState aside = pressed(steep, 0.3_nm);
    ASSERT_LT(aside.closest.normal.z(), 0.79);
    aside.contact = above.contact;  // the same depth along the normal
    const HalfSpaceAnswer first = HalfSpaceModel().solve(level, above);
    const HalfSpaceAnswer second = HalfSpaceModel().solve(steep, aside);
    ASSERT_TRUE(first.valid());
    ASSERT_TRUE(second.valid());
    EXPECT_NEAR(second.force, first.force, 1e-6 * adhesionUnit(level));
    EXPECT_NEAR(second.contactRadius, first.contactRadius, 1e-6 * first.contactRadius);
    EXPECT_NEAR(second.field->at(3.0_nm, 4.0_nm), first.field->at(3.0_nm, 4.0_nm), 1e-6_nm);
}

/// No point of the displaced surface lies inside of the undeformed tip when the sample takes all
/// of the displacement, and over the contact it lies on the tip.
TEST(HalfSpaceModel, PutsRealTopographyOntoTheTip) {
    SceneDescription description = test::plainScene();
    description.tip.elastic.youngsModulus = 1e15;
    description.choices.law = ContactLaw::Split;
    description.choices.deformation = DeformationModel::HalfSpace;
    const Scene scene = buildScene(description, test::hillyMap());
    const TipState state = pressed(scene, 0.25_nm, {20.0_nm, 18.0_nm});
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    ASSERT_TRUE(answer.valid()) << nameOf(answer.verdict);
    const SurfacePatch patch = halfSpacePatch(scene, answer, {.halfWidth = 6.0_nm, .samples = 81});
    const TipContact contact = tipContact(scene, state);
    const Vector3 center =
        contact.closest + (contact.tipRadius - contact.indentation) * contact.normal;
    double touching = 0.0;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        const double gap = (patch.points[i] - center).norm() - contact.tipRadius;
        EXPECT_GT(gap, -0.004_nm);
        const Vector3 moved = patch.points[i] - patch.rest[i];
        EXPECT_LT(moved.cross(contact.normal).norm(), 1e-20) << "moves along the normal only";
        touching += gap < 0.004_nm ? 1.0 : 0.0;
    }
    EXPECT_GT(touching, 100.0);
}

TEST(HalfSpaceModel, StartsFromTheAnswerBefore) {
    const Scene scene = sceneOn(test::hillyMap());
    TipState state = pressed(scene, 0.2_nm);
    HalfSpaceModel model;
    (void)model.solve(scene, state);
    state.contact.indentation += 0.02_nm;
    const HalfSpaceAnswer warm = model.solve(scene, state);
    const HalfSpaceAnswer cold = HalfSpaceModel().solve(scene, state);
    ASSERT_TRUE(warm.valid());
    EXPECT_NEAR(warm.force, cold.force, 5e-3 * adhesionUnit(scene));
    EXPECT_LE(warm.iterations, cold.iterations);
}

TEST(HalfSpaceModel, GivesWayToTheClosedFormWhereItDoesNotHold) {
    const Scene scene = sceneOn(test::flatMap());
    const TipState deep = pressed(scene, 1.5_nm);
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, deep);
    EXPECT_EQ(answer.verdict, HalfSpaceVerdict::LargeContact);
    EXPECT_EQ(answer.field, nullptr);
    const PatchGrid grid{.halfWidth = 30.0_nm, .samples = 41};
    const SurfacePatch shown = exactPatch(scene, deep, DeformationModel::HalfSpace, grid);
    const SurfacePatch closed = exactPatch(scene, deep, DeformationModel::ClosedForm, grid);
    EXPECT_EQ(shown.points, closed.points);
}

/// Dugdale's zone beside JKR: a radius of 2.20 nm for 2.76 nm, which it called valid.
TEST(HalfSpaceModel, DoesNotAnswerForALawWhoseAdhesionHasNoCohesiveZone) {
    for (const ContactLaw law : {ContactLaw::Jkr, ContactLaw::SphereJkr, ContactLaw::Dmt}) {
        SCOPED_TRACE(nameOf(law));
        const Scene scene = sceneOn(test::flatMap(), law);
        const TipState state = pressed(scene, 0.1_nm);
        const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
        EXPECT_EQ(answer.verdict, HalfSpaceVerdict::NoZone);
        EXPECT_EQ(answer.field, nullptr);
        SceneDescription bare = scene.description;
        bare.sample.material.workOfAdhesion = 0.0;
        bare.truth.material = bare.sample.material;
        const Scene hertzian = buildScene(bare, test::flatMap());
        EXPECT_TRUE(HalfSpaceModel().solve(hertzian, pressed(hertzian, 0.3_nm)).valid())
            << "without adhesion it is Hertz";
    }
}

TEST(HalfSpaceModel, HasNothingToSayWithoutContact) {
    const Scene scene = sceneOn(test::flatMap());
    EquilibriumMemory memory;
    const TipState state = tipEquilibrium(scene.surface, scene.belief,
                                          {.position = {64.0_nm, 64.0_nm, 5.0_nm}}, memory);
    EXPECT_EQ(HalfSpaceModel().solve(scene, state).verdict, HalfSpaceVerdict::NotBonded);
}

TEST(HalfSpaceModel, StopsWhenAsked) {
    const Scene scene = sceneOn(test::flatMap());
    std::stop_source source;
    source.request_stop();
    HalfSpaceModel model(HalfSpaceModel::kSamples, {.tolerance = 1e-12});
    EXPECT_EQ(model.solve(scene, pressed(scene, 0.3_nm), source.get_token()).verdict,
              HalfSpaceVerdict::Canceled);
}

TEST(TangentFrame, SeesAPlaneAsLevelFromItsOwnSide) {
    const Scene scene = sceneOn(test::slopedMap(0.8));
    const Vector3 normal = Vector3(-0.8, 0.0, 1.0).normalized();
    const TangentFrame frame = tangentFrame({60.0_nm, 60.0_nm, 48.0_nm}, normal);
    EXPECT_NEAR((frame.along.cross(frame.across) - normal).norm(), 0.0, 1e-15);
    for (const double height : heightsOver(scene.surface, frame, 16, 1.0_nm)) {
        EXPECT_NEAR(height, 0.0, 1e-6_nm);
    }
}

TEST(TangentFrame, MeetsHillsAlongTheNormal) {
    const Scene scene = sceneOn(test::hillyMap());
    const HeightSample sample = scene.surface.at(70.0_nm, 20.0_nm);
    const TangentFrame frame = tangentFrame({70.0_nm, 20.0_nm, sample.height}, sample.normal());
    const std::vector<double> heights = heightsOver(scene.surface, frame, 20, 1.0_nm);
    for (int i = 0; i < 400; ++i) {
        const int row = i / 20;
        const Vector3 point = frame.origin + (i % 20 - 9.5) * 1.0_nm * frame.along +
                              (row - 9.5) * 1.0_nm * frame.across +
                              heights[static_cast<std::size_t>(i)] * frame.normal;
        EXPECT_NEAR(scene.surface.at(point.x(), point.y()).height, point.z(), 1e-5_nm);
    }
}

}  // namespace
}  // namespace asperity
