#include "core/scene/ShapeSample.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Scene.h"
#include "core/surface/deformation/ContactHeight.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

constexpr double kRadius = 100.0_nm;

Scene sceneOf(const ShapeDescription& shape) {
    SceneDescription description = test::plainScene();
    description.sample.shape = shape;
    return buildScene(description);
}

const ShapeDescription kBall{.kind = ShapeKind::Sphere, .radius = kRadius, .size = 110.0_nm};
const ShapeDescription kRod{.kind = ShapeKind::Cylinder, .radius = kRadius, .size = 150.0_nm};
const ShapeDescription kSlope{.kind = ShapeKind::Plane, .slope = 0.7, .size = 150.0_nm};

TEST(ShapeSample, IsDrawnWhereItIsTouched) {
    for (const ShapeDescription& shape : {kBall, kRod, kSlope}) {
        const Scene scene = sceneOf(shape);
        for (int i = 0; i <= 20; ++i) {
            for (int j = 0; j <= 20; ++j) {
                const double x = shape.size * (0.02 + 0.96 * i / 20.0);
                const double y = shape.size * (0.02 + 0.96 * j / 20.0);
                const HeightSample drawn = scene.surface.at(x, y);
                const ClosestPoint closest = scene.trueSurface().localContactPoint(
                    Vector3(x, y, drawn.height), SearchGuess{});
                ASSERT_NEAR(closest.distance, 0.0, 1e-6 * shape.size);
                ASSERT_LT((closest.normal - drawn.normal()).norm(), 2e-4);
            }
        }
    }
}

/// A tip on a ball meets it along the line between the two centers, with R_eff = R r / (R + r).
TEST(ShapeSample, ABallIsTouchedAsABall) {
    const Scene scene = sceneOf(kBall);
    const double tipRadius = scene.description.tip.radius;
    const Vector3 center(0.5 * kBall.size, 0.5 * kBall.size, kRadius);
    for (const Vector3& towards : {Vector3(0.0, 0.0, 1.0), Vector3(0.2, -0.1, 1.0)}) {
        const Vector3 direction = towards.normalized();
        const Vector3 tipCenter = center + (kRadius + tipRadius - 1.0_nm) * direction;
        const BaseMotion held{.position = tipCenter - Vector3(0.0, 0.0, tipRadius)};
        const TipState state = heldTip(scene.trueSurface(), scene.belief, held, {});
        EXPECT_TRUE(state.converged);
        EXPECT_LT((state.closest.normal - direction).norm(), 1e-12);
        EXPECT_NEAR(state.closest.distance, tipRadius - 1.0_nm, 1e-13 * kRadius);
        EXPECT_NEAR(state.effectiveRadius, kRadius * tipRadius / (kRadius + tipRadius),
                    1e-9 * tipRadius);
        EXPECT_TRUE(state.closest.insideScan);
    }
}

/// 1.59 pi w R_eff by Maugis and Dugdale, and the tail.
TEST(ShapeSample, ABluntTipIsHeldByASmallBallAsByTheBallAlone) {
    SceneDescription description = test::plainScene();
    description.tip.radius = 5.0_um;
    description.sample.shape = {.kind = ShapeKind::Sphere, .radius = 50.0_nm, .size = 60.0_nm};
    const Scene scene = buildScene(description);
    const BaseMotion base{.position = {30.0_nm, 30.0_nm, 99.0_nm}};
    EquilibriumMemory memory;
    const TipState state = tipEquilibrium(scene.trueSurface(), scene.belief, base, memory);
    EXPECT_NEAR(state.effectiveRadius, 49.5_nm, 0.01_nm);
    EXPECT_LT(state.contact.contactRadius, 0.3 * state.effectiveRadius);
    const double soft = 1e3;  // [m/N]: pull-off under a load
    EXPECT_NEAR(contactModelAt(scene, state).lastBonded(soft).force, -16.8_nN, 0.1_nN);
}

TEST(ShapeSample, ASlopeIsTouchedAcrossIt) {
    const Scene scene = sceneOf(kSlope);
    const Vector3 normal(-std::sin(kSlope.slope), 0.0, std::cos(kSlope.slope));
    const double tipRadius = scene.description.tip.radius;
    const Vector3 tipCenter =
        Vector3(0.5 * kSlope.size, 0.4 * kSlope.size, 0.0) + (tipRadius - 1.0_nm) * normal;
    const TipState state = heldTip(scene.trueSurface(), scene.belief,
                                   {.position = tipCenter - Vector3(0.0, 0.0, tipRadius)}, {});
    EXPECT_LT((state.closest.normal - normal).norm(), 1e-14);
    EXPECT_NEAR(state.effectiveRadius, tipRadius, 1e-9 * tipRadius);
    EXPECT_EQ(state.points, 1);
}

TEST(ShapeSample, RunsStartOnTopOfIt) {
    for (const ShapeDescription& shape : {kBall, kRod}) {
        const Scene scene = sceneOf(shape);
        EXPECT_NEAR(highestPoint(scene.surface, 0.03).height, 2.0 * kRadius, 1e-5_nm);
        const double touch =
            tipContactHeight(scene.surface, 0.5 * shape.size, 0.5 * shape.size, 15.0_nm);
        EXPECT_NEAR(touch, 2.0 * kRadius + 15.0_nm, 1e-5_nm);
    }
}

TEST(ShapeSample, KeepsItsShapeWithAnotherMaterial) {
    SampleMaterial soft = test::plainScene().sample.material;
    soft.elastic.youngsModulus = 1e8;
    const Scene scene = withMaterial(sceneOf(kBall), soft);
    ASSERT_TRUE(scene.shape.has_value());
    EXPECT_NEAR(scene.shape->curvatures(0.4, 0.6).largest, 1.0 / kRadius, 1e-9 / kRadius);
}

TEST(ShapeSample, RefusesWhatNoPictureShows) {
    for (const ShapeDescription& shape :
         {ShapeDescription{.kind = ShapeKind::Sphere, .radius = kRadius, .size = 1.3 * kRadius},
          ShapeDescription{.kind = ShapeKind::Cylinder, .radius = kRadius, .size = 1.8 * kRadius},
          ShapeDescription{.kind = ShapeKind::Plane, .slope = 1.5, .size = kRadius},
          ShapeDescription{.kind = ShapeKind::Plane, .slope = std::nan(""), .size = kRadius},
          ShapeDescription{.kind = ShapeKind::Sphere, .radius = 0.0, .size = kRadius}}) {
        EXPECT_THROW((void)sceneOf(shape), Error);
    }
    EXPECT_THROW((void)buildScene(test::plainScene()), Error) << "neither map nor shape";
}

}  // namespace
}  // namespace asperity
