#include "core/scene/ScanSmoothing.h"

#include "core/Random.h"
#include "core/scene/Scene.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity {
namespace {

constexpr double kTip = 15e-9;  // [m]
constexpr double kTolerated = 0.05;
constexpr ScanSize kSmoothedScan{128, 128, 128e-9, 128e-9};
const SelfAffine kRough{.rms = 2e-9,
                        .hurst = 0.8,
                        .longestWave = 128e-9,
                        .rollOffWave = 64e-9,
                        .shortestWave = 4e-9,
                        .seed = 3};

HeightMap withNoise(HeightMap map, double noise) {
    Random random(11);
    for (double& height : map.heights) {
        height += noise * random.normal();
    }
    return map;
}

HeightMap scaled(HeightMap map, double scale) {
    map.pitchX *= scale;
    map.pitchY *= scale;
    for (double& height : map.heights) {
        height *= scale;
    }
    return map;
}

SmoothingChoice chosenFor(const HeightMap& map, double scale = 1.0) {
    return chooseSmoothing(CurvatureNoise(map), scale * kTip, kTolerated);
}

TEST(ScanSmoothing, IsNoneWhereAScanIsClean) {
    const std::vector<HeightMap> clean{
        flatMap(kSmoothedScan),
        sampledMap(kSmoothedScan, EggBox{.amplitude = 5e-9, .periodX = 50e-9, .periodY = 50e-9}),
        sampledMap(kSmoothedScan, AtomicSteps({.stepHeight = 0.235e-9,
                                               .terraceWidth = 30e-9,
                                               .edgeWidth = 1e-9,
                                               .jitter = 2e-9,
                                               .angle = 0.3},
                                              kSmoothedScan)),
        sampledMap(kSmoothedScan, Nanoparticles({.count = 4,
                                                 .medianRadius = 8e-9,
                                                 .spread = 0.2,
                                                 .smallest = 5e-9,
                                                 .largest = 12e-9,
                                                 .scanTipRadius = 10e-9},
                                                kSmoothedScan)),
        sampledMap(kSmoothedScan, TrapezoidGrating{.pitch = 40e-9,
                                                   .depth = 10e-9,
                                                   .topWidth = 15e-9,
                                                   .flankWidth = 8e-9,
                                                   .angle = 0.2}),
        selfAffineMap(kSmoothedScan, kRough)};
    for (std::size_t i = 0; i < clean.size(); ++i) {
        EXPECT_EQ(chosenFor(clean[i]).pixels, 0.0) << i;
    }
}

/// The closed form of docs/uncertainty.md 1.4: (sqrt(2 / pi) / 4 R sigma / (tolerance p^2))^(1/3),
/// a few percent more where pixels are no continuum.
TEST(ScanSmoothing, GrowsWithTheThirdRootOfTheNoise) {
    for (const double noise : {30e-12, 100e-12, 300e-12}) {
        const double expected = std::cbrt(0.19947 * kTip * noise / (kTolerated * 1e-18));
        const SmoothingChoice choice = chosenFor(withNoise(flatMap(kSmoothedScan), noise));
        EXPECT_GE(choice.pixels, 0.97 * expected) << noise;
        EXPECT_LE(choice.pixels, 1.15 * expected) << noise;
        EXPECT_FALSE(choice.isBounded);
    }
}

TEST(ScanSmoothing, IsTheSameWhateverTheScale) {
    for (const HeightMap& map : {withNoise(flatMap(kSmoothedScan), 50e-12),
                                 withNoise(selfAffineMap(kSmoothedScan, kRough), 100e-12)}) {
        const SmoothingChoice choice = chosenFor(map);
        EXPECT_GT(choice.pixels, 0.0);
        for (double scale = 0.125; scale <= 64.0; scale *= 2.0) {
            EXPECT_EQ(chosenFor(scaled(map, scale), scale), choice) << scale;
        }
    }
}

/// A blunt tip would have more noise taken out than there is curvature left.
TEST(ScanSmoothing, StopsWhereItTakesMoreThanNoiseLeaves) {
    const HeightMap map = withNoise(selfAffineMap(kSmoothedScan, kRough), 100e-12);
    const CurvatureNoise scan(map);
    const SmoothingChoice choice = chooseSmoothing(scan, 1e-6, kTolerated);
    EXPECT_TRUE(choice.isBounded);
    EXPECT_LT(choice.pixels, 2.5);
    const Smoothing width{choice.pixels, choice.pixels};
    EXPECT_LE(scan.blur(width, scan.noise(width)), scan.noise(width));
}

TEST(ScanSmoothing, AToleranceOfZeroSmoothsNoMoreThanAHundredth) {
    const CurvatureNoise scan(withNoise(flatMap(kSmoothedScan), 30e-12));
    EXPECT_EQ(chooseSmoothing(scan, kTip, 0.0), chooseSmoothing(scan, kTip, 0.01));
}

TEST(ScanSmoothing, IsStatedByTheSceneOnceItIsBuilt) {
    SceneDescription description = test::plainScene();
    description.sample.smoothingPixels.reset();
    const HeightMap map = withNoise(test::flatMap(), 50e-12);
    const Scene scene = buildScene(description, map);
    ASSERT_TRUE(scene.smoothing);
    EXPECT_GT(scene.smoothing->pixels, 0.0);
    EXPECT_EQ(scene.description.sample.smoothingPixels, scene.smoothing->pixels);
    const Scene again = buildScene(scene.description, map);
    EXPECT_FALSE(again.smoothing) << "stated now";
    EXPECT_EQ(again.surface.grid().controlHeights, scene.surface.grid().controlHeights);
    EXPECT_EQ(again.heightNoise, scene.heightNoise);

    SceneDescription blunter = description;
    blunter.tip.radius *= 4.0;
    EXPECT_GT(buildScene(blunter, map).smoothing->pixels, scene.smoothing->pixels);
    const Scene same = withDescription(scene, blunter);
    EXPECT_EQ(same.description.sample.smoothingPixels, scene.smoothing->pixels)
        << "a surface is what it was smoothed by";
}

TEST(ScanSmoothing, KnownNoiseCountsInPlaceOfTheEstimate) {
    SceneDescription description = test::plainScene();
    description.sample.smoothingPixels.reset();
    description.uncertainty.heightNoise = 400e-12;
    const Scene scene = buildScene(description, test::hillyMap());
    EXPECT_GT(scene.description.sample.smoothingPixels, 1.0);
    EXPECT_NEAR(scene.heightNoise, 400e-12, 1e-20);
}

}  // namespace
}  // namespace asperity
