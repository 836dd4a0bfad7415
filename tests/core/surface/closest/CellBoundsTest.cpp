#include "core/surface/CellBounds.h"

#include "tests/core/surface/closest/RoughSurface.h"
#include "tests/support/FloatingPointTraps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

ASPERITY_TRAP_FLOATING_POINT();

namespace asperity {

namespace {

using test::RoughMap;

std::vector<RoughMap> roughMaps() {
    return {
        {.name = "Noise", .columns = 33, .rows = 20, .range = 20.0_nm},
        {.name = "Smooth", .columns = 70, .rows = 75, .range = 20.0_nm, .smoothing = 2.0},
        {.name = "WidePixels", .columns = 24, .rows = 30, .pitchX = 9.0_nm, .range = 20.0_nm},
        {.name = "TallPixels", .columns = 24, .rows = 30, .pitchY = 9.0_nm, .range = 20.0_nm},
        {.name = "SingleRow", .columns = 40, .rows = 1, .range = 5.0_nm},
        {.name = "SingleColumn", .columns = 1, .rows = 40, .range = 5.0_nm},
        {.name = "OnePixel", .columns = 1, .rows = 1, .range = 5.0_nm},
        {.name = "TwoByTwo", .columns = 2, .rows = 2, .range = 5.0_nm},
        {.name = "ThreeByTwo", .columns = 3, .rows = 2, .range = 5.0_nm},
        {.name = "Constant", .columns = 12, .rows = 12, .range = 0.0, .offset = 3.0_nm},
        {.name = "Zero", .columns = 12, .rows = 12, .range = 0.0},
        {.name = "Picometer", .columns = 33, .rows = 20, .range = 1.0_pm},
        {.name = "Millimeter", .columns = 33, .rows = 20, .range = 1e-3},
        {.name = "FarOff", .columns = 33, .rows = 20, .range = 1.0_nm, .offset = 1e-3},
        {.name = "FarBelow", .columns = 33, .rows = 20, .range = 1.0_nm, .offset = -1e-3},
    };
}

/// The positions that a block covers, world [m].
struct Patch {
    double lowX = 0.0;
    double highX = 0.0;
    double lowY = 0.0;
    double highY = 0.0;
};

/// Cells lie between pixel centers; the outermost reach to the scan's edge.
Patch patchOf(const BSplineSurface& surface, int level, int row, int column) {
    const BSplineSurface::Grid& grid = surface.grid();
    const int cells = 1 << (3 * level);
    const CellBounds::Level& blocks = surface.bounds().level(level);
    return {.lowX = column == 0 ? 0.0 : (column * cells + 0.5) * grid.pitchX,
            .highX = column == blocks.columns - 1 ? surface.sizeX()
                                                  : ((column + 1) * cells + 0.5) * grid.pitchX,
            .lowY = row == 0 ? 0.0 : (row * cells + 0.5) * grid.pitchY,
            .highY =
                row == blocks.rows - 1 ? surface.sizeY() : ((row + 1) * cells + 0.5) * grid.pitchY};
}

/// What samples of a patch show.
struct Seen {
    double lowest = std::numeric_limits<double>::max();      ///< [m]
    double highest = std::numeric_limits<double>::lowest();  ///< [m]
    double upwardBend = 0.0;  ///< largest second derivative in any direction [1/m]
    double bend = 0.0;        ///< largest magnitude of one [1/m]

    void add(const HeightSample& s) {
        const double mean = 0.5 * (s.dxx + s.dyy);
        const double spread = std::hypot(0.5 * (s.dxx - s.dyy), s.dxy);
        lowest = std::min(lowest, s.height);
        highest = std::max(highest, s.height);
        upwardBend = std::max(upwardBend, mean + spread);
        bend = std::max(bend, std::abs(mean) + spread);
    }
};

/// Corners and sides, where bounds are reached, and positions between.
Seen seenIn(const BSplineSurface& surface, const Patch& patch, Random& random) {
    constexpr int kSteps = 8;
    Seen seen;
    const auto look = [&](double shareX, double shareY) {
        seen.add(surface.at(std::lerp(patch.lowX, patch.highX, shareX),
                            std::lerp(patch.lowY, patch.highY, shareY)));
    };
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            look(i / double{kSteps}, j / double{kSteps});
            look(random.uniform(), random.uniform());
        }
    }
    return seen;
}

class CellBoundsOf : public testing::TestWithParam<RoughMap> {
protected:
    BSplineSurface surface_ = surfaceOf(GetParam());

    template <class Check>
    void forEachBlock(int level, const Check& check) const {
        const CellBounds::Level& blocks = surface_.bounds().level(level);
        Random random(3);
        for (int row = 0; row < blocks.rows; ++row) {
            for (int column = 0; column < blocks.columns; ++column) {
                const Seen seen = seenIn(surface_, patchOf(surface_, level, row, column), random);
                check(surface_.bounds().at(level, row, column), seen);
            }
        }
    }
};

TEST_P(CellBoundsOf, HoldEverywhereOnEveryLevel) {
    for (int level = 0; level < surface_.bounds().levels(); ++level) {
        forEachBlock(level, [&](const BoxBounds& bounds, const Seen& seen) {
            ASSERT_LE(bounds.lowest, seen.lowest) << level;
            ASSERT_GE(bounds.highest, seen.highest) << level;
            // Samples have rounding errors of their own: of the slopes between control heights.
            const BSplineSurface::Grid& grid = surface_.grid();
            const double pitch = std::min(grid.pitchX, grid.pitchY);
            const double rounding =
                1e-15 * (surface_.heightScale() - std::abs(grid.datum)) / (pitch * pitch);
            ASSERT_GE(bounds.concavity, seen.upwardBend - rounding) << level;
        });
    }
}

/// Bezier points can lie beyond a bicubic by a multiple of its range, mostly by a small share of
/// it; codes add an eighth.
TEST_P(CellBoundsOf, OfACellAreTight) {
    const CellBounds::Units units = surface_.bounds().units();
    const double step = static_cast<double>(units.step);
    double excess = 0.0;
    double ranges = 0.0;
    forEachBlock(0, [&](const BoxBounds& bounds, const Seen& seen) {
        const double range = seen.highest - seen.lowest;
        ASSERT_LE(bounds.highest - seen.highest, 1.5 * range + 3.0 * step);
        ASSERT_LE(seen.lowest - bounds.lowest, 1.5 * range + 8.0 * step);
        ASSERT_LE(bounds.concavity, 4.0 * seen.bend + 1e-6 * double{units.concavity});
        excess += std::max(0.0, bounds.highest - seen.highest - 3.0 * step);
        ranges += range;
    });
    EXPECT_LE(excess, 0.2 * ranges);
}

TEST_P(CellBoundsOf, OfAllAreThoseOfTheLargestBlock) {
    const BoxBounds all = surface_.bounds().all();
    forEachBlock(0, [&](const BoxBounds& bounds, const Seen&) {
        ASSERT_LE(all.lowest, bounds.lowest);
        ASSERT_GE(all.highest, bounds.highest);
        ASSERT_GE(all.concavity, bounds.concavity);
    });
}

INSTANTIATE_TEST_SUITE_P(Surfaces, CellBoundsOf, testing::ValuesIn(roughMaps()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(CellBounds, HaveABlockOfEightTimesEightToEachOfTheNextLevel) {
    const BSplineSurface surface = test::surfaceOf({.name = "", .columns = 70, .rows = 10});
    ASSERT_EQ(surface.bounds().levels(), 4);
    EXPECT_EQ(surface.bounds().level(0).columns, 69);
    EXPECT_EQ(surface.bounds().level(1).columns, 9);
    EXPECT_EQ(surface.bounds().level(1).rows, 2);
    EXPECT_EQ(surface.bounds().level(3).rows, 1);
}

TEST(ShortCode, IsNeverLessThanTheNumberNorAnEighthMore) {
    Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const auto number = static_cast<float>(std::exp2(random.uniform(-30.0, 0.9)));
        const float decoded = decodedShort(encodedShort(number));
        ASSERT_GE(decoded, number);
        ASSERT_LE(decoded, 1.125F * number);
    }
    EXPECT_EQ(decodedShort(encodedShort(kMaxShortCode)), kMaxShortCode);
    EXPECT_LT(decodedShort(encodedShort(0.0F)), 1e-9F);
}

}  // namespace
}  // namespace asperity
