#include "ui/view/ContactShape.h"

#include "core/Units.h"
#include "core/deformation/ContactDeformation.h"
#include "core/deformation/HalfSpaceModel.h"
#include "tests/support/TestScenes.h"
#include "tests/ui/view/ViewMoments.h"
#include "tests/ui/view/WindowAround.h"
#include "ui/view/ViewFrame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace asperity {

namespace {

using test::windowAround;

constexpr int kSamples = 65;

class ContactShapeOnHills : public ::testing::TestWithParam<DeformationModel> {
protected:
    static Scene sceneOf(DeformationModel model) {
        SceneDescription description = test::plainScene();
        description.choices.deformation = model;
        return buildScene(description, test::hillyMap());
    }
};

TEST_P(ContactShapeOnHills, DeformsTheSurfaceAsPicturesAndFilesDo) {
    const Scene scene = sceneOf(GetParam());
    const test::ViewMoments moments = test::momentsOf(scene);
    for (const Snapshot& moment : {moments.deep, moments.neck}) {
        const TipState& state = moment.sample.output.model;
        const ContactShape shape(scene, state, windowAround(state.tip, 30.0_nm), kSamples);
        const PatchGrid grid{.halfWidth = 12.0_nm, .samples = 41};
        const SurfacePatch patch =
            drawnPatch(scene, ContactDeformation(scene, state, GetParam()), grid);
        for (std::size_t i = 0; i < patch.rest.size(); ++i) {
            EXPECT_EQ(shape.moved(patch.rest[i]), patch.points[i]) << "as files hold it";
        }
        EXPECT_GT(shape.largestDisplacement(), 0.1_nm);
    }
}

TEST(ContactShape, ShowsTheHalfSpaceWhereItStillHoldsAndElseTheClosedForm) {
    SceneDescription description = test::plainScene();
    description.choices.deformation = DeformationModel::HalfSpace;
    const Scene scene = buildScene(description, test::hillyMap());
    const TipState state = test::momentsOf(scene).neck.sample.output.model;
    const HalfSpaceAnswer answer = HalfSpaceModel().solve(scene, state);
    ASSERT_TRUE(answer.valid()) << nameOf(answer.verdict);
    const ScanWindow area = windowAround(state.tip, 30.0_nm);
    const ContactShape solved(scene, state, area, kSamples, &answer);
    const ContactShape closed(scene, state, area, kSamples);
    const PatchGrid grid{.halfWidth = 12.0_nm, .samples = 41};
    const SurfacePatch exact = drawnPatch(
        scene, ContactDeformation(scene, state, DeformationModel::HalfSpace, &answer), grid);
    double differences = 0.0;
    for (std::size_t i = 0; i < exact.rest.size(); ++i) {
        EXPECT_EQ(solved.moved(exact.rest[i]), exact.points[i]) << "as files hold it";
        differences += (closed.moved(exact.rest[i]) - exact.points[i]).norm();
    }
    EXPECT_GT(differences, 1e-10) << "the two do differ on hills";
    TipState elsewhere = state;
    elsewhere.closest.point.x() += 10.0_nm;
    EXPECT_FALSE(stillHolds(answer, elsewhere));
    const ContactShape late(scene, elsewhere, area, kSamples, &answer);
    const ContactShape there(scene, elsewhere, area, kSamples);
    EXPECT_EQ(late.moved(state.closest.point), there.moved(state.closest.point));
}

INSTANTIATE_TEST_SUITE_P(EveryModel, ContactShapeOnHills,
                         ::testing::Values(DeformationModel::ClosedForm,
                                           DeformationModel::ContactRadius,
                                           DeformationModel::FourPoint));

TEST(ContactShape, IsAtRestAlongItsBorder) {
    const Scene scene = test::hillyScene();
    const TipState state = test::momentsOf(scene).deep.sample.output.model;
    const ContactShape shape(scene, state, windowAround(state.tip, 20.0_nm), kSamples);
    const SurfacePatch& patch = shape.patch();
    for (int i = 0; i < kSamples; ++i) {
        for (const std::size_t index : {patch.index(0, i), patch.index(kSamples - 1, i),
                                        patch.index(i, 0), patch.index(i, kSamples - 1)}) {
            EXPECT_EQ(patch.points[index], patch.rest[index]);
            EXPECT_EQ(shape.displacements()[index], 0.0);
        }
    }
}

/// Beyond the scan's edge there is nothing to join: the dent goes on up to it.
TEST(ContactShape, IsNotAtRestAlongTheScansEdge) {
    const Scene scene = test::flatScene();
    const Snapshot deep = test::momentsOf(scene).deep;
    const double reach = 20.0_nm;
    for (const Vector3& way : {Vector3(-64.0_nm, 0.0, 0.0), Vector3(64.0_nm, 0.0, 0.0),
                               Vector3(0.0, -64.0_nm, 0.0), Vector3(64.0_nm, 64.0_nm, 0.0)}) {
        const TipState state = test::movedBy(deep, way).sample.output.model;
        const ScanWindow scan{.left = 0.0, .right = 128.0_nm, .bottom = 0.0, .top = 128.0_nm};
        const ScanWindow area = windowAround(state.tip.head<2>(), reach, scan);
        const ContactShape shape(scene, state, area, kSamples);
        EXPECT_NEAR((state.closest.point - shape.contactPoint()).z(), state.contact.indentation,
                    0.05 * state.contact.indentation);
        const Vector3 goesOn(area.left == 0.0 ? area.right : area.left, state.closest.point.y(),
                             state.closest.point.z());
        EXPECT_EQ(shape.moved(goesOn), goesOn) << "at rest where the surface goes on";
        for (int i = 1; i < kSamples; ++i) {
            const SurfacePatch& patch = shape.patch();
            EXPECT_GT(patch.rest[patch.index(0, i)].x(), patch.rest[patch.index(0, i - 1)].x());
            EXPECT_GT(patch.rest[patch.index(i, 0)].y(), patch.rest[patch.index(i - 1, 0)].y());
        }
    }
}

TEST(ContactShape, FillsAScanSmallerThanTheView) {
    const Scene scene = test::flatScene();
    const TipState state = test::momentsOf(scene).deep.sample.output.model;
    const ScanWindow scan{.left = 0.0, .right = 128.0_nm, .bottom = 0.0, .top = 128.0_nm};
    const ContactShape shape(scene, state, scan, kSamples);
    EXPECT_NEAR((state.closest.point - shape.contactPoint()).z(), state.contact.indentation,
                0.05 * state.contact.indentation);
}

TEST(ContactShape, SamplesTheContactMostFinely) {
    const Scene scene = test::flatScene();
    const TipState state = test::momentsOf(scene).neck.sample.output.model;
    const ContactShape shape(scene, state, windowAround(state.tip, 30.0_nm), kSamples);
    const SurfacePatch& patch = shape.patch();
    int inContact = 0;
    for (int column = 0; column < kSamples; ++column) {
        const Vector3& rest = patch.rest[patch.index(kSamples / 2, column)];
        inContact += std::abs(rest.x() - state.closest.point.x()) <= state.contact.contactRadius;
        EXPECT_TRUE(column == 0 ||
                    rest.x() > patch.rest[patch.index(kSamples / 2, column - 1)].x());
    }
    EXPECT_GE(inContact, 8) << "across a neck of " << state.contact.contactRadius << " m";
}

TEST(ContactShape, GivesTheTipItsShareOfTheDisplacement) {
    SceneDescription description = test::plainScene();
    description.sample.material.elastic = description.tip.elastic;  // equals share alike
    const Scene scene = buildScene(description, test::flatMap());
    const TipState state = test::momentsOf(scene).deep.sample.output.model;
    const ContactShape shape(scene, state, windowAround(state.tip, 30.0_nm), kSamples);
    EXPECT_NEAR(shape.tipDisplacement(0.0), 0.5 * state.contact.indentation,
                0.02 * state.contact.indentation);
    EXPECT_NEAR((shape.contact().closest - shape.contactPoint()).z(), shape.tipDisplacement(0.0),
                1e-15);
}

TEST(ContactShape, GivesAStiffTipHardlyAny) {
    const Scene scene = test::flatScene();  // silicon on polystyrene
    const TipState state = test::momentsOf(scene).deep.sample.output.model;
    const ContactShape shape(scene, state, windowAround(state.tip, 30.0_nm), kSamples);
    EXPECT_GT(shape.tipDisplacement(0.0), 0.0);
    EXPECT_LT(shape.tipDisplacement(0.0), 0.03 * state.contact.indentation);
}

TEST(ContactShape, OnlyFiniteStatesAreDrawable) {
    TipState state;
    EXPECT_TRUE(isDrawable(state));
    state.tip.y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(isDrawable(state));
    state = {};
    state.contact.indentation = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(isDrawable(state));
}

}  // namespace
}  // namespace asperity
