#include "core/Error.h"
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/closest/BoxNewton.h"
#include "core/surface/deformation/DisplacementField.h"
#include "core/surface/fit/BSplineFit.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity {
namespace {

BSplineSurface roughSurface(int columns, int rows) {
    HeightMap map = flatMap(
        {.columns = columns, .rows = rows, .sizeX = columns * 2.0_nm, .sizeY = rows * 5.0_nm});
    Random random(23);
    for (double& height : map.heights) {
        height = random.uniform(-5.0_nm, 5.0_nm);
    }
    return fitSurface(map);
}

void expectSameSurface(const SplinePatch& patch, const BSplineSurface& surface, const Box& box) {
    for (int i = 0; i <= 30; ++i) {
        for (int j = 0; j <= 30; ++j) {
            const double x = std::lerp(box.low.x(), box.high.x(), i / 30.0);
            const double y = std::lerp(box.low.y(), box.high.y(), j / 30.0);
            const HeightSample sample = surface.at(x, y);
            const Vector3 expected(x, y, sample.height);
            ASSERT_LT((patch.point(x, y) - expected).norm(), 1e-12 * 5.0_nm);
            ASSERT_LT((patch.normal(x, y) - sample.normal()).norm(), 1e-9);
        }
    }
}

TEST(SurfaceRefinement, IsTheSameSurfaceAtEverySpacing) {
    const BSplineSurface surface = roughSurface(14, 11);
    const Box box{.low = {7.1_nm, 12.3_nm}, .high = {16.8_nm, 33.0_nm}};
    for (const double spacing : {10.0_nm, 2.0_nm, 0.9_nm, 0.15_nm}) {
        const SplinePatch patch = refined(surface, box, spacing);
        EXPECT_LE(patch.x.spacing, spacing);
        EXPECT_LE(patch.y.spacing, spacing);
        EXPECT_GT(2.0 * patch.x.spacing, std::min(spacing, 2.0_nm));
        EXPECT_TRUE(patch.contains(box.low.x(), box.low.y()));
        EXPECT_TRUE(patch.contains(box.high.x(), box.high.y()));
        expectSameSurface(patch, surface, box);
    }
}

TEST(SurfaceRefinement, HoldsOnlyWhatTheWindowNeeds) {
    const SplinePatch patch = refined(
        roughSurface(60, 60), {.low = {50.0_nm, 50.0_nm}, .high = {54.0_nm, 54.0_nm}}, 0.125_nm);
    EXPECT_LE(patch.x.count, 32 + 4 + 1);
    EXPECT_EQ(patch.controls.size(), static_cast<std::size_t>(patch.x.count * patch.y.count));
}

TEST(SurfaceRefinement, ReachesToTheScansEdgeAndNoFarther) {
    const BSplineSurface surface = roughSurface(8, 6);
    const SplinePatch patch =
        refined(surface, {.low = {-40.0_nm, -40.0_nm}, .high = {90.0_nm, 90.0_nm}}, 0.4_nm);
    const Box scan = scanBox(surface);
    expectSameSurface(patch, surface, scan);
    EXPECT_LE(patch.x.high(), surface.sizeX() + 2.0_nm);
    EXPECT_GE(patch.y.low(), -5.0_nm);
}

TEST(SurfaceRefinement, WorksOnThinScans) {
    for (const auto& [columns, rows] : {std::pair{1, 1}, {2, 2}, {1, 9}, {9, 1}, {3, 2}}) {
        const BSplineSurface surface = roughSurface(columns, rows);
        const Box scan = scanBox(surface);
        expectSameSurface(refined(surface, scan, 0.3_nm), surface, scan);
    }
}

TEST(SurfaceRefinement, StopsBeforeThePatchGrowsTooLarge) {
    const BSplineSurface surface = roughSurface(40, 40);
    const SplinePatch patch = refined(surface, scanBox(surface), 1.0_pm);
    EXPECT_LE(patch.controls.size(), kMaxPatchControls);
    EXPECT_GT(patch.controls.size(), kMaxPatchControls / 4);
    EXPECT_GT(patch.x.spacing * patch.y.spacing, 1.0_pm * 1.0_pm);
}

TEST(SurfaceRefinement, RefusesSpacingsAndWindowsThatAreNone) {
    const BSplineSurface surface = roughSurface(8, 6);
    EXPECT_THROW((void)refined(surface, scanBox(surface), 0.0), Error);
    EXPECT_THROW((void)refined(surface, scanBox(surface), std::nan("")), Error);
    EXPECT_THROW((void)refined(surface, {.low = {std::nan(""), 0.0}, .high = {1.0, 1.0}}, 1.0_nm),
                 Error);
}

}  // namespace
}  // namespace asperity
