// Bounds are kept in a few bits and in single precision. Here they meet surfaces whose heights and
// bends are known exactly and lie where a code ends, so that a bound rounded the wrong way is
// wrong.
#include "core/Random.h"
#include "core/Units.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/CellBounds.h"
#include "core/surface/closest/BoundsWindow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace asperity {
namespace {

/// Pixels of a surface of which each control height is given.
struct Pixels {
    int columns = 8;
    int rows = 8;
    double pitchX = 2.0_nm;  ///< [m]
    double pitchY = 2.0_nm;  ///< [m]
    double datum = 0.0;      ///< [m]
};

/// @param control height at (row, column) of the control grid, above the datum [m]
template <class Control>
BSplineSurface surfaceWith(const Pixels& pixels, const Control& control) {
    BSplineSurface::Grid grid{.columns = pixels.columns,
                              .rows = pixels.rows,
                              .pitchX = pixels.pitchX,
                              .pitchY = pixels.pitchY,
                              .datum = pixels.datum,
                              .controlHeights = {},
                              .invalid = {}};
    for (int row = 0; row < pixels.rows + 2; ++row) {
        for (int column = 0; column < pixels.columns + 2; ++column) {
            grid.controlHeights.push_back(control(row, column));
        }
    }
    return BSplineSurface(std::move(grid));
}

/// The lowest and the highest control height, from which the codes' units come.
struct Extremes {
    float low = 0.0F;   ///< [m]
    float high = 0.0F;  ///< [m]
};

/// `control` but for the last corner, which holds the extremes. With 8 x 8 pixels the cells
/// kInnerCell and kBorderCell do not feel them.
template <class Control>
BSplineSurface surfaceBetween(const Pixels& pixels, const Extremes& extremes,
                              const Control& control) {
    return surfaceWith(pixels, [&](int row, int column) {
        if (row == pixels.rows + 1 && column >= pixels.columns) {
            return column == pixels.columns ? extremes.low : extremes.high;
        }
        return static_cast<float>(control(row, column));
    });
}

/// All but the corner lies at one height, exactly.
BSplineSurface plateau(const Pixels& pixels, const Extremes& extremes, float height) {
    return surfaceBetween(pixels, extremes, [height](int, int) { return height; });
}

constexpr int kInnerCell = 3;   // row and column
constexpr int kBorderCell = 0;  // row and column

Extremes randomExtremes(Random& random) {
    const double range = std::exp2(random.uniform(-50.0, -10.0));
    return {.low = static_cast<float>(-range * random.uniform(0.2, 1.0)),
            .high = static_cast<float>(range * random.uniform(0.2, 1.0))};
}

/// A height near the datum, where single precision is finest, at which the code of the upper or
/// that of the lower bound ends, or a little beside it.
float heightAtACodesEnd(const CellBounds::Units& units, Random& random) {
    const double step = double{units.step};
    const double code = std::round(-units.base / step + random.uniform(-100.0, 100.0));
    const double beside = step * random.uniform(-0.003, 0.003);
    if (random.uniform() < 0.5) {
        return static_cast<float>(units.base + code * step + beside);
    }
    const float steps = static_cast<float>(random.uniform(0.5, 3.0)) * units.step;
    const float drop = units.drop * decodedShort(encodedShort(steps / units.drop));
    return static_cast<float>(units.base + code * step - double{drop} + beside);
}

/// What the heights of a cell are, exactly.
struct ExactHeights {
    long double lowest = 0.0L;   ///< world [m]
    long double highest = 0.0L;  ///< world [m]
};

void expectHolds(const BSplineSurface& surface, int cell, const ExactHeights& heights) {
    const BoxBounds bounds = surface.bounds().at(0, cell, cell);
    EXPECT_LE(bounds.lowest, heights.lowest) << cell;
    EXPECT_GE(bounds.highest, heights.highest) << cell;
}

TEST(BoundsRounding, AHeightAtTheEndOfACodeIsHeld) {
    Random random(21);
    for (int i = 0; i < 6000 && !testing::Test::HasFailure(); ++i) {
        const Extremes extremes = randomExtremes(random);
        const CellBounds::Units units = plateau({}, extremes, 0.0F).bounds().units();
        const float height = heightAtACodesEnd(units, random);
        const BSplineSurface surface = plateau({}, extremes, height);
        expectHolds(surface, kInnerCell, {height, height});
        expectHolds(surface, kBorderCell, {height, height});
    }
}

/// Slopes of one rounding step a pixel: between control heights, half a step is no single number.
TEST(BoundsRounding, HeightsThatHardlyDifferFarFromTheDatumAreHeld) {
    Random random(22);
    for (int i = 0; i < 3000 && !testing::Test::HasFailure(); ++i) {
        const double middle = std::ldexp(random.uniform(1.0, 1.9), -5 - i % 35);
        const auto height = static_cast<float>(i % 2 == 0 ? middle : -middle);
        const float little = std::abs(height) * std::exp2(-12.0F - static_cast<float>(i % 11));
        const float steps = static_cast<float>(i % 3 - 1) * std::ldexp(1.0F, -28 - i % 35);
        const BSplineSurface surface =
            surfaceBetween({}, {.low = height - little, .high = height + little},
                           [&](int, int column) { return height + steps * column; });
        // Cell 0 begins half a pixel before the control height 1 and ends at 2.
        const auto between = [&](double first, double last) {
            const long double a = height + static_cast<long double>(steps) * first;
            const long double b = height + static_cast<long double>(steps) * last;
            return ExactHeights{std::min(a, b), std::max(a, b)};
        };
        expectHolds(surface, kInnerCell, between(kInnerCell + 1, kInnerCell + 2));
        expectHolds(surface, kBorderCell, between(0.5, 2.0));
    }
}

/// height = xx i^2 + xy i j + yy j^2 at pixel (j, i): the same bends everywhere.
struct Quadric {
    int xx = 0;
    int xy = 0;
    int yy = 0;
    float unit = 1.0F;  ///< of the height: a power of 2, so that all control heights are exact [m]

    [[nodiscard]] float control(int row, int column) const {
        const int i = column - kInnerCell;
        const int j = row - kInnerCell;
        return unit * static_cast<float>(xx * i * i + xy * i * j + yy * j * j);
    }
    /// Largest second derivative in any direction [1/m].
    [[nodiscard]] long double largestBend(const Pixels& pixels) const {
        const long double pitchX = pixels.pitchX;
        const long double pitchY = pixels.pitchY;
        const long double alongX = 2.0L * unit * xx / (pitchX * pitchX);
        const long double alongY = 2.0L * unit * yy / (pitchY * pitchY);
        const long double mixed = 1.0L * unit * xy / (pitchX * pitchY);
        return 0.5L * (alongX + alongY) + std::hypot(0.5L * (alongX - alongY), mixed);
    }
};

TEST(BoundsRounding, ABendAtTheEndOfACodeIsHeld) {
    Random random(23);
    const auto whole = [&random](double low, double high) {
        return static_cast<int>(std::round(random.uniform(low, high)));
    };
    for (int i = 0; i < 6000 && !testing::Test::HasFailure(); ++i) {
        const Quadric quadric{.xx = whole(1.0, 9.0),
                              .xy = whole(-9.0, 9.0),
                              .yy = whole(-9.0, 9.0),
                              .unit = 0x1p-33F};
        const Pixels pixels{.pitchX = 2.0_nm, .pitchY = 2.0_nm * std::exp2(random.uniform(-6, 6))};
        const auto surfaceOfRange = [&](double range) {
            return surfaceBetween(
                pixels,
                {.low = -4096.0F * quadric.unit,
                 .high = static_cast<float>(range) - 4096.0F * quadric.unit},
                [&](int row, int column) { return quadric.control(row, column); });
        };
        // The unit of the bends grows with the range of heights: the range that puts a code's end
        // at the quadric's bend, or next to it.
        const double range = double{quadric.unit} * random.uniform(8192.0, 16384.0);
        const auto bend = static_cast<double>(quadric.largestBend(pixels));
        const double unit = double{surfaceOfRange(range).bounds().units().concavity};
        const double end = double{decodedShort(encodedShort(static_cast<float>(bend / unit)))};
        const BSplineSurface surface =
            surfaceOfRange(range * bend / (unit * end) * (1.0 + random.uniform(-5e-7, 5e-7)));
        for (const int cell : {kInnerCell, kBorderCell}) {
            EXPECT_GE(surface.bounds().at(0, cell, cell).concavity, quadric.largestBend(pixels))
                << cell;
        }
    }
}

TEST(BoundsRounding, WhatIsALittleMoreThanAShortCodeHasTheNext) {
    for (int code = 0; code < 255; ++code) {
        const float end = decodedShort(static_cast<std::uint8_t>(code));
        EXPECT_EQ(encodedShort(end), code);
        EXPECT_EQ(encodedShort(std::nextafter(end, kMaxShortCode)), code + 1);
    }
}

/// Whether the window around a query says that a cell may hold a point within the distance.
bool isReached(const BSplineSurface& surface, const Vector3& query, double distance,
               const Vector2& position) {
    const BoundsWindow window(surface, query, distance);
    const int row = window.rowAt(position.y());
    const int column = window.columnAt(position.x());
    return row >= 0 && row < window.rows().count && column >= 0 &&
           column < window.columns().count &&
           ((window.reaching(row) >> static_cast<unsigned>(column)) & 1U) != 0 &&
           window.reaches(row, column, distance);
}

/// The position of a cell that is nearest to (x, y) [m]; not quite at the cell's far sides, which
/// belong to the next cells.
Vector2 nearestInCell(const BSplineSurface::Grid& grid, int row, int column, const Vector3& query) {
    const auto nearest = [](double position, int cell, double pitch) {
        const double low = (cell + 0.5) * pitch;
        return std::clamp(position, low, low + pitch * (1.0 - 1e-12));
    };
    return {nearest(query.x(), column, grid.pitchX), nearest(query.y(), row, grid.pitchY)};
}

/// Not less than the distance between two points, and hardly more [m].
double distanceBetween(const Vector3& a, const Vector3& b) {
    const Eigen::Vector3<long double> between = a.cast<long double>() - b.cast<long double>();
    return std::nextafter(static_cast<double>(between.norm()),
                          std::numeric_limits<double>::infinity());
}

/// Queries about a surface that is level at the datum, but for the corner that holds the extremes.
/// @param highest above or below the surface that queries lie [m]
void expectReachesWhatLiesAtTheDistance(const Pixels& pixels, const Extremes& extremes,
                                        double highest) {
    const BSplineSurface surface = plateau(pixels, extremes, 0.0F);
    Random random(25);
    for (int i = 0; i < 4000; ++i) {
        const Vector3 query(random.uniform() * surface.sizeX(), random.uniform() * surface.sizeY(),
                            pixels.datum + highest * random.uniform(-1.0, 1.0));
        const int row = static_cast<int>(random.uniform() * (pixels.rows - 6)) + 1;
        const int column = static_cast<int>(random.uniform() * (pixels.columns - 6)) + 1;
        const Vector2 position = nearestInCell(surface.grid(), row, column, query);
        const double distance = distanceBetween(query, {position.x(), position.y(), pixels.datum});
        ASSERT_TRUE(isReached(surface, query, distance, position))
            << "datum " << pixels.datum << " query " << query.transpose() << " cell " << row << ' '
            << column;
    }
}

TEST(BoundsRounding, ACellThatHoldsAPointExactlyAtTheDistanceIsReached) {
    const Pixels square{.columns = 28, .rows = 28};
    Pixels far = square;
    far.datum = 0x1p-10;
    Pixels narrow = square;
    narrow.pitchY = 2.0_um;
    for (const Pixels& pixels : {square, far, narrow}) {
        for (const float range : {0x1p-60F, 0x1p-40F, 0x1p-30F, 0x1p-20F, 0x1p-10F}) {
            for (const double share : {0.0, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
                expectReachesWhatLiesAtTheDistance(pixels, {.low = -range, .high = range},
                                                   share * double{range});
            }
        }
    }
}

}  // namespace
}  // namespace asperity
