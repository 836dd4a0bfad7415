#include "core/surface/sample/SampleSurface.h"

#include "core/Units.h"
#include "core/surface/closest/ContactPoints.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/nurbs/NurbsShapes.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/TestTip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

using test::kTipRadius;

/// Two slopes of 45 degrees that meet along y at x = 0, z = 0.
NurbsSurface groove() {
    return NurbsSurface({.degreeU = 1,
                         .degreeV = 1,
                         .knotsU = {0.0, 0.0, 1.0, 2.0, 2.0},
                         .knotsV = {0.0, 0.0, 1.0, 1.0},
                         .points = {{-50.0_nm, 0.0, 50.0_nm},
                                    {0.0, 0.0, 0.0},
                                    {50.0_nm, 0.0, 50.0_nm},
                                    {-50.0_nm, 100.0_nm, 50.0_nm},
                                    {0.0, 100.0_nm, 0.0},
                                    {50.0_nm, 100.0_nm, 50.0_nm}},
                         .weights = {}});
}

TEST(SampleSurface, ATipInAGrooveHasTwoClosestPoints) {
    ClosestPointTracker tracker;
    const NurbsSurface surface = groove();
    const SampleSurface sample(surface);
    // Nearer to the left slope by a nanometer.
    const Vector3 center(-0.5_nm * std::numbers::sqrt2, 40.0_nm, kTipRadius * std::numbers::sqrt2);
    const ContactPoints points = sample.contactPoints({center, kTipRadius}, 10.0_nm, {}, tracker);
    EXPECT_EQ(points.proof, SearchProof::Nearest);
    ASSERT_EQ(points.list.all().size(), 2U);
    EXPECT_NEAR(points.list.all()[0].distance, kTipRadius - 0.5_nm, 1e-12_nm);
    EXPECT_NEAR(points.list.all()[1].distance, kTipRadius + 0.5_nm, 1e-12_nm);
    EXPECT_LT(points.list.all()[0].point.x(), 0.0);
    for (const ClosestPoint& closest : points.list.all()) {
        const ClosestPoint again = sample.localContactPoint(center, closest.guess());
        EXPECT_LT((again.point - closest.point).norm(), 1e-12_nm)
            << "each is found again from itself";
        EXPECT_NEAR(std::abs(closest.normal.x()), std::numbers::sqrt2 / 2.0, 1e-12);
        EXPECT_NEAR(closest.curvatures.largest, 0.0, 1e-6 / kTipRadius);
    }
    EXPECT_EQ(sample.contactPoints({center, kTipRadius}, 0.0, {}, tracker).list.all().size(), 1U)
        << "the other one is out of reach";
}

TEST(SampleSurface, ATipOnABallHasOne) {
    ClosestPointTracker tracker;
    const NurbsSurface ball = sphereSurface({.center = Vector3::Zero()}, 100.0_nm);
    EXPECT_EQ(ball.concavity(), 0.0);
    const SampleSurface sample(ball);
    const Vector3 above(0.0, 0.0, 120.0_nm);
    const ContactPoints near = sample.contactPoints({above, kTipRadius}, 10.0_nm, {}, tracker);
    ASSERT_EQ(near.list.all().size(), 1U);
    EXPECT_EQ(near.proof, SearchProof::Nearest);
    EXPECT_EQ(sample.contactPoints({above, kTipRadius}, 1.0_nm, {}, tracker).proof,
              SearchProof::OutOfReach);
    const ContactPoints none =
        sample.contactPoints({Vector3::Constant(NAN), kTipRadius}, 10.0_nm, {}, tracker);
    EXPECT_EQ(none.proof, SearchProof::NotConverged);
    ASSERT_EQ(none.list.all().size(), 1U);
    EXPECT_TRUE(none.list.all()[0].point.allFinite());
}

TEST(SampleSurface, AHeightFieldIsTouchedAsItIs) {
    ClosestPointTracker tracker;
    const BSplineSurface field = fitSurface(
        sampledMap({.columns = 32, .rows = 32, .sizeX = 64.0_nm, .sizeY = 64.0_nm},
                   EggBox{.amplitude = 10.0_nm, .periodX = 30.0_nm, .periodY = 30.0_nm}));
    const TipSphere tip{.center = Vector3(30.0_nm, 31.0_nm, 20.0_nm), .radius = kTipRadius};
    const ContactPoints direct = contactPoints(field, tip, 10.0_nm, {});
    const ContactPoints points = SampleSurface(field).contactPoints(tip, 10.0_nm, {}, tracker);
    ASSERT_EQ(points.list.all().size(), direct.list.all().size());
    EXPECT_EQ(points.proof, direct.proof);
    EXPECT_EQ(points.list.all()[0].point, direct.list.all()[0].point);
}

}  // namespace
}  // namespace asperity
