#include "core/surface/imaging/TipErosion.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/surface/synthetic/SyntheticSurface.h"
#include "tests/core/surface/imaging/ErosionDefinition.h"
#include "tests/support/DoubleLimits.h"
#include "tests/support/ProgressRecorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace asperity {
namespace {

using test::erosionAt;
using test::forEachPixel;
using test::kEpsilon;
using test::kNan;
using test::tipIsWithin;

HeightMap roughMap() {
    return selfAffineMap({.columns = 150, .rows = 90, .sizeX = 150.0_nm, .sizeY = 120.0_nm},
                         {.rms = 3.0_nm,
                          .hurst = 0.7,
                          .longestWave = 120.0_nm,
                          .rollOffWave = 60.0_nm,
                          .shortestWave = 4.0_nm,
                          .seed = 5});
}

void expectSame(const HeightMap& a, const HeightMap& b, double tolerance) {
    forEachPixel(a, [&](int row, int column) {
        ASSERT_NEAR(a.at(row, column), b.at(row, column), tolerance);
    });
}

TEST(TipErosion, IsBelowTheImageAndDilationAboveTheSurface) {
    const HeightMap map = roughMap();
    const HeightMap below = eroded(map, 12.0_nm);
    const HeightMap above = dilated(map, 12.0_nm);
    double lowered = 0.0;
    forEachPixel(map, [&](int row, int column) {
        EXPECT_LE(below.at(row, column), map.at(row, column));
        EXPECT_GE(above.at(row, column), map.at(row, column));
        lowered = std::max(lowered, map.at(row, column) - below.at(row, column));
    });
    EXPECT_GT(lowered, 1.0_nm);
}

TEST(TipErosion, ReconstructsABoundThatGivesTheSameImage) {
    const HeightMap surface = roughMap();
    const HeightMap image = dilated(surface, 12.0_nm);
    const TipReconstruction reconstruction = reconstructed(image, 12.0_nm);
    const double rounding = 8.0 * kEpsilon * 20.0_nm;
    expectSame(dilated(reconstruction.surface, 12.0_nm), image, rounding);
    expectSame(eroded(dilated(reconstruction.surface, 12.0_nm), 12.0_nm), reconstruction.surface,
               rounding);
    forEachPixel(surface, [&](int row, int column) {
        EXPECT_GE(reconstruction.surface.at(row, column), surface.at(row, column) - rounding);
    });
}

TEST(TipErosion, OpeningAnImageTwiceChangesNothingMore) {
    const auto opened = [](const HeightMap& map) { return dilated(eroded(map, 9.0_nm), 9.0_nm); };
    const HeightMap once = opened(roughMap());
    expectSame(opened(once), once, 8.0 * kEpsilon * 20.0_nm);
}

TEST(TipErosion, AWiderTipReconstructsNoHigherSurface) {
    const HeightMap image = roughMap();
    const HeightMap slim = eroded(image, 6.0_nm);
    const HeightMap wide = eroded(image, 12.0_nm);
    forEachPixel(
        image, [&](int row, int column) { EXPECT_LE(wide.at(row, column), slim.at(row, column)); });
}

/// Where the tip fits into every hollow it touches all of the surface. On the pixel grid, it does
/// so between pixels, too; where it is proven to touch one, the surface comes back to rounding.
TEST(TipErosion, UndoesDilationOfASurfaceThatTheTipFits) {
    const EggBox shape{.amplitude = 4.0_nm, .periodX = 200.0_nm, .periodY = 160.0_nm};
    const ScanSize size{.columns = 300, .rows = 200, .sizeX = 300.0_nm, .sizeY = 200.0_nm};
    const HeightMap surface = sampledMap(size, shape);
    const double tip = 50.0_nm;  // the sharpest hollow has a radius of 162 nm
    const TipReconstruction back = reconstructed(dilated(surface, tip), tip);
    const double bound = 0.5 * 0.5 * 1.0_nm * 1.0_nm * (1.0 / tip + 1.0 / 160.0_nm);
    double largest = 0.0;
    int inside = 0;
    int certain = 0;
    forEachPixel(surface, [&](int row, int column) {
        const bool isInside = tipIsWithin(surface, row, column, 1.2 * tip);
        const bool isCertain = back.certain[surface.index(row, column)] != 0;
        const double error = back.surface.at(row, column) - surface.at(row, column);
        EXPECT_LE(isCertain ? std::abs(error) : 0.0, 1e-12 * tip);
        largest = std::max(largest, isInside ? error : 0.0);
        inside += isInside ? 1 : 0;
        certain += isInside && isCertain ? 1 : 0;
    });
    EXPECT_LE(largest, bound);
    EXPECT_GT(2 * certain, inside);
    std::printf("egg box 4 nm under a tip of 50 nm: %.0f %% certain, the others up to %.2g nm "
                "high\n",
                100.0 * certain / inside, largest * 1e9);
}

/// A sphere of 20 nm that a tip of 8 nm shows as one of 28 nm. From pixel to pixel its top keeps
/// the image's curvature. A paraboloid leaves 0.064 pitch^3 of the third derivative, that of tip
/// less image at a slope of 30 degrees being 0.044 / nm^2: 9.5 pm.
TEST(TipErosion, BetweenPixelsIsTheParallelSurface) {
    constexpr double kTip = 8e-9;
    constexpr double kSphere = 20e-9;
    const auto squareAt = [](const HeightMap& map, int row, int column) {
        const double x = (column - (0.5 * (map.columns - 1))) * map.pitchX;
        const double y = (row - (0.5 * (map.rows - 1))) * map.pitchY;
        return (x * x) + (y * y);
    };
    HeightMap image = flatMap({.columns = 41, .rows = 41, .sizeX = 61.5_nm, .sizeY = 61.5_nm});
    forEachPixel(image, [&](int row, int column) {
        const double wide = kSphere + kTip;
        const double cap = (wide * wide) - squareAt(image, row, column);
        image.heights[image.index(row, column)] =
            std::max(0.0, std::sqrt(std::max(0.0, cap)) - kTip);
    });
    const auto largestError = [&](TouchedPoint point) {
        const HeightMap surface = reconstructed(image, kTip, nullptr, point).surface;
        double largest = 0.0;
        forEachPixel(surface, [&](int row, int column) {
            const double square = squareAt(surface, row, column);
            if (square < 100e-18) {
                const double height = std::sqrt((kSphere * kSphere) - square);
                largest = std::max(largest, std::abs(surface.at(row, column) - height));
            }
        });
        return largest;
    };
    const double byPixels = largestError(TouchedPoint::Pixel);
    EXPECT_GT(byPixels, 20e-12);
    EXPECT_LT(largestError(TouchedPoint::BetweenPixels), 9.5e-12);
}

/// Beside the foot of a step the tip rests on the edge: what lies there is not proven, however
/// close the pixel is to one that is.
TEST(TipErosion, ThePixelBesideAStepIsUncertain) {
    HeightMap surface = flatMap({.columns = 60, .rows = 40, .sizeX = 60.0_nm, .sizeY = 40.0_nm});
    forEachPixel(surface, [&](int row, int column) {
        surface.heights[surface.index(row, column)] = column < 30 ? 8.0_nm : 0.0;
    });
    const TipReconstruction back = reconstructed(dilated(surface, 10.0_nm), 10.0_nm);
    EXPECT_EQ(back.certain[surface.index(20, 29)], 1) << "the edge";
    EXPECT_EQ(back.certain[surface.index(20, 30)], 0) << "the foot";
    EXPECT_GT(back.surface.at(20, 30), 1.0_nm);
    EXPECT_EQ(back.certain[surface.index(20, 45)], 1) << "the lower terrace";
}

TEST(TipErosion, TheFloorOfATrenchThatTheTipDoesNotFitIsUncertain) {
    const TrapezoidGrating shape{
        .pitch = 200.0_nm, .depth = 20.0_nm, .topWidth = 184.0_nm, .flankWidth = 0.0};
    const ScanSize size{.columns = 300, .rows = 100, .sizeX = 300.0_nm, .sizeY = 100.0_nm};
    const HeightMap surface = sampledMap(size, shape);
    const double tip = 30.0_nm;  // the trench is 16 nm wide: the tip sinks in by about 1 nm
    const TipReconstruction back = reconstructed(dilated(surface, tip), tip);
    int floors = 0;
    for (int column = 40; column < 260; ++column) {
        const bool isFloor = surface.at(50, column) < 10.0_nm;
        const bool isCertain = back.certain[surface.index(50, column)] != 0;
        EXPECT_EQ(isCertain, !isFloor) << column;
        if (isFloor) {
            EXPECT_GT(back.surface.at(50, column), surface.at(50, column) + 15.0_nm);
            ++floors;
        }
    }
    EXPECT_GE(floors, 15);
}

TEST(TipErosion, LeavesAFlatSurfaceFlatAndCertainWhereTheTipLiesOverTheMap) {
    HeightMap map = flatMap({.columns = 30, .rows = 24, .sizeX = 30.0_nm, .sizeY = 48.0_nm});
    std::ranges::fill(map.heights, 7.0_nm);
    const TipReconstruction back = reconstructed(map, 5.0_nm);
    EXPECT_EQ(back.surface.heights, map.heights);
    forEachPixel(map, [&](int row, int column) {
        EXPECT_EQ(back.certain[map.index(row, column)] != 0, tipIsWithin(map, row, column, 5.0_nm));
    });
}

TEST(TipErosion, RowsWithoutDataStayAndTakeNoPart) {
    HeightMap missing = roughMap();
    for (int row = 60; row < 90; ++row) {
        for (int column = 0; column < missing.columns; ++column) {
            missing.heights[missing.index(row, column)] = kNan;
        }
    }
    HeightMap masked = missing;
    masked.invalid.assign(masked.heights.size(), 0);
    for (std::size_t i = masked.index(60, 0); i < masked.heights.size(); ++i) {
        masked.heights[i] = -1.0;
        masked.invalid[i] = 1;
    }
    const TipReconstruction a = reconstructed(missing, 12.0_nm);
    const TipReconstruction b = reconstructed(masked, 12.0_nm);
    EXPECT_EQ(a.certain, b.certain);
    EXPECT_EQ(b.surface.invalid, masked.invalid);
    forEachPixel(missing, [&](int row, int column) {
        if (row < 60) {
            EXPECT_EQ(a.surface.at(row, column), b.surface.at(row, column));
            return;
        }
        EXPECT_FALSE(isFiniteHeight(a.surface.at(row, column)));
        EXPECT_EQ(b.surface.at(row, column), -1.0);
        EXPECT_EQ(a.certain[missing.index(row, column)], 0);
    });
}

/// Over the rim of a hole the tip may rest on something inside it.
TEST(TipErosion, NothingIsCertainAtTheRimOfAHole) {
    HeightMap map = flatMap({.columns = 40, .rows = 40, .sizeX = 40.0_nm, .sizeY = 40.0_nm});
    map.heights[map.index(20, 20)] = kNan;
    const TipReconstruction back = reconstructed(map, 6.0_nm);
    EXPECT_EQ(back.certain[map.index(20, 20)], 0);
    EXPECT_EQ(back.certain[map.index(20, 21)], 0);
    EXPECT_EQ(back.certain[map.index(20, 22)], 1);
}

TEST(TipErosion, ATipSmallerThanAPixelChangesNothing) {
    const HeightMap map = roughMap();
    const TipReconstruction back = reconstructed(map, 0.9_nm);
    EXPECT_EQ(back.surface.heights, map.heights);
    EXPECT_EQ(std::ranges::count(back.certain, 1), static_cast<long>(map.heights.size()));
    EXPECT_EQ(dilated(map, 0.9_nm).heights, map.heights);
}

TEST(TipErosion, ATipWiderThanTheMapIsCertainOfNothing) {
    const HeightMap map = roughMap();
    const TipReconstruction back = reconstructed(map, 1000.0_um);
    EXPECT_EQ(std::ranges::count(back.certain, 1), 0);
    const double lowest = *std::ranges::min_element(map.heights);
    for (int row = 0; row < map.rows; ++row) {
        EXPECT_EQ(back.surface.at(row, row), erosionAt(map, row, row, 1000.0_um));
        EXPECT_LT(back.surface.at(row, row), lowest + 0.1_nm);
    }
}

TEST(TipErosion, OfTwoByTwoPixels) {
    HeightMap map = flatMap({.columns = 2, .rows = 2, .sizeX = 6.0_nm, .sizeY = 8.0_nm});
    map.heights = {0.0, 5.0_nm, 1.0_nm, 9.0_nm};
    // Of a tip of 5 nm: 5 - 4 nm higher 3 nm away, 5 - 3 nm higher 4 nm away, 5 nm at the corner.
    const HeightMap surface = eroded(map, 5.0_nm);
    const double tolerance = 1e-6 * 1.0_nm;
    EXPECT_EQ(surface.at(0, 0), 0.0);
    EXPECT_NEAR(surface.at(0, 1), 1.0_nm, tolerance);
    EXPECT_EQ(surface.at(1, 0), 1.0_nm);
    EXPECT_NEAR(surface.at(1, 1), 2.0_nm, tolerance);
    const HeightMap image = dilated(map, 5.0_nm);
    EXPECT_NEAR(image.at(0, 0), 4.0_nm, tolerance);
    EXPECT_NEAR(image.at(0, 1), 7.0_nm, tolerance);
    EXPECT_NEAR(image.at(1, 0), 8.0_nm, tolerance);
    EXPECT_EQ(image.at(1, 1), 9.0_nm);
}

TEST(TipErosion, OfOneLineOfPixels) {
    HeightMap row = flatMap({.columns = 20, .rows = 1, .sizeX = 60.0_nm, .sizeY = 3.0_nm});
    row.heights[10] = 9.0_nm;
    HeightMap column = flatMap({.columns = 1, .rows = 20, .sizeX = 3.0_nm, .sizeY = 60.0_nm});
    column.heights[10] = 9.0_nm;
    EXPECT_NEAR(eroded(row, 5.0_nm).heights[10], 1.0_nm, 1e-6 * 1.0_nm);
    EXPECT_NEAR(dilated(row, 5.0_nm).heights[9], 8.0_nm, 1e-6 * 1.0_nm);
    EXPECT_EQ(eroded(row, 5.0_nm).heights, eroded(column, 5.0_nm).heights);
    EXPECT_EQ(dilated(row, 5.0_nm).heights, dilated(column, 5.0_nm).heights);
}

TEST(TipErosion, RefusesARadiusThatIsNoLength) {
    const HeightMap map = roughMap();
    for (const double radius : {0.0, -1.0_nm, kNan, std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW((void)eroded(map, radius), Error);
        EXPECT_THROW((void)dilated(map, radius), Error);
        EXPECT_THROW((void)reconstructed(map, radius), Error);
    }
    EXPECT_THROW((void)eroded(HeightMap{}, 1.0_nm), Error);
}

TEST(TipReconstruction, TellsHowFarItIs) {
    const HeightMap map =
        sampledMap({.columns = 200, .rows = 900, .sizeX = 200.0_nm, .sizeY = 900.0_nm},
                   EggBox{.amplitude = 5.0_nm, .periodX = 60.0_nm, .periodY = 60.0_nm});
    test::ProgressRecorder recorder(2.0);
    (void)reconstructed(map, 10.0_nm, &recorder);
    EXPECT_GE(recorder.fractions.size(), 10U);
    EXPECT_TRUE(std::ranges::is_sorted(recorder.fractions));
    EXPECT_GT(recorder.fractions.back(), 0.8);
    EXPECT_LE(recorder.fractions.back(), 1.0);
}

TEST(TipReconstruction, EndsWhenItIsCanceled) {
    const HeightMap map =
        sampledMap({.columns = 200, .rows = 900, .sizeX = 200.0_nm, .sizeY = 900.0_nm},
                   EggBox{.amplitude = 5.0_nm, .periodX = 60.0_nm, .periodY = 60.0_nm});
    for (const double fraction : {0.0, 0.2, 0.7}) {
        test::ProgressRecorder recorder(fraction);
        EXPECT_THROW((void)reconstructed(map, 10.0_nm, &recorder), Canceled);
        EXPECT_LT(recorder.fractions.back(), fraction + 0.2);
    }
}

}  // namespace
}  // namespace asperity
