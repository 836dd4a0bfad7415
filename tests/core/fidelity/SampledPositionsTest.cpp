#include "core/Units.h"
#include "core/fidelity/SampledRuns.h"
#include "core/haptics/DevicePath.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

/// The tip that touches the sample there, without load.
TipState touchAt(const Scene& scene, const Vector2& position) {
    EquilibriumMemory memory;
    const double height = touchHeight(scene, position.x(), position.y());
    return heldTip(scene.believedSurface(), scene.belief,
                   {.position = Vector3(position.x(), position.y(), height)}, memory);
}

TEST(SampledPositions, OfAPlaneOneIsEnough) {
    EXPECT_EQ(sampledPositions(buildScene(test::plainScene(), test::flatMap())).size(), 1U);
    EXPECT_EQ(sampledPositions(buildScene(test::plainScene(), test::slopedMap(0.2))).size(), 1U);
}

TEST(SampledPositions, HoldTheExtremesOfRadiusAndSlope) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    double least = std::numeric_limits<double>::infinity();
    double largest = 0.0;
    double steepest = 0.0;
    for (const Vector2& position : sampledPositions(scene)) {
        const TipState touch = touchAt(scene, position);
        least = std::min(least, touch.effectiveRadius);
        largest = std::max(largest, touch.effectiveRadius);
        steepest = std::max(steepest, std::abs(touch.closest.normal.x()));
    }
    for (double x = 10.0_nm; x < 118.0_nm; x += 3.7_nm) {
        for (double y = 10.0_nm; y < 118.0_nm; y += 3.7_nm) {
            const TipState touch = touchAt(scene, {x, y});
            EXPECT_GE(touch.effectiveRadius, 0.98 * least) << x << ", " << y;
            EXPECT_LE(touch.effectiveRadius, 1.02 * largest) << x << ", " << y;
            EXPECT_LE(std::abs(touch.closest.normal.x()), steepest + 0.02) << x << ", " << y;
        }
    }
}

TEST(SampledPositions, LookIntoTheHollowThatTheTipDoesNotFit) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    const std::vector<Vector2> positions = sampledPositions(scene);
    const double groove = std::fmod(positions.back().x(), 60.0_nm);
    EXPECT_NEAR(groove, 45.0_nm, 2.0_nm);
}

TEST(SampledPositions, LieInTheScan) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(25.0_nm));
    for (const Vector2& position : sampledPositions(scene)) {
        EXPECT_TRUE(scene.surface.contains(position.x(), position.y()));
    }
}

}  // namespace
}  // namespace asperity
