#include "core/surface/measure/Roughness.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {

namespace {

/// Rows of a rectangle from the top down, with the one above.
class RectangleRows {
public:
    RectangleRows(const HeightRows& map, const PixelRectangle& pixels)
        : map_(map), pixels_(pixels), whole_(static_cast<std::size_t>(map.columns)) {}

    /// Calls visit(row, above), both const std::vector<double>&; `above` is empty for the first.
    template <class Visit>
    void forEach(Progress* progress, const Visit& visit) {
        std::vector<double> above;
        std::vector<double> row(static_cast<std::size_t>(pixels_.columns));
        for (int i = 0; i < pixels_.rows; ++i) {
            if (i % kStep == 0) {
                reportTo(progress, static_cast<double>(i) / pixels_.rows);
            }
            map_.readRow(pixels_.row + i, whole_.data());
            std::copy_n(whole_.begin() + pixels_.column, pixels_.columns, row.begin());
            visit(row, above);
            std::swap(row, above);
            row.resize(above.size());
        }
    }

private:
    static constexpr int kStep = 64;
    const HeightRows& map_;
    PixelRectangle pixels_;
    std::vector<double> whole_;
};

/// Mean and extremes.
struct Heights {
    double origin = 0.0;  ///< that the sum starts from: an offset costs no digits [m]
    double sum = 0.0;     ///< [m]
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    std::size_t count = 0;

    void add(const std::vector<double>& row) {
        double ofRow = 0.0;
        for (const double height : row) {
            if (!isFiniteHeight(height)) {
                continue;
            }
            origin = count == 0 ? height : origin;
            ofRow += height - origin;
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
            ++count;
        }
        sum += ofRow;
    }
    [[nodiscard]] double mean() const { return origin + sum / static_cast<double>(count); }
};

/// Sums of distances from the mean.
struct Deviations {
    double absolute = 0.0;  ///< [m]
    double square = 0.0;    ///< [m^2]
    double cube = 0.0;      ///< [m^3]
    double fourth = 0.0;    ///< [m^4]

    void add(const std::vector<double>& row, double mean) {
        Deviations ofRow;
        for (const double height : row) {
            if (isFiniteHeight(height)) {
                const double deviation = height - mean;
                const double squared = deviation * deviation;
                ofRow.absolute += std::abs(deviation);
                ofRow.square += squared;
                ofRow.cube += squared * deviation;
                ofRow.fourth += squared * squared;
            }
        }
        absolute += ofRow.absolute;
        square += ofRow.square;
        cube += ofRow.cube;
        fourth += ofRow.fourth;
    }
};

/// Gradient of the squares, and their surface, in units of their outline, beyond it.
class SquareSums {
public:
    SquareSums(double pitchX, double pitchY) : pitchX_(pitchX), pitchY_(pitchY) {}

    void add(const std::vector<double>& row, const std::vector<double>& above) {
        double surplusOfRow = 0.0;
        double gradientOfRow = 0.0;
        for (std::size_t i = 1; i < above.size(); ++i) {
            const double topLeft = above[i - 1];
            const double topRight = above[i];
            const double bottomLeft = row[i - 1];
            const double bottomRight = row[i];
            if (!(isFiniteHeight(topLeft) && isFiniteHeight(topRight) &&
                  isFiniteHeight(bottomLeft) && isFiniteHeight(bottomRight))) {
                continue;
            }
            // A triangle has the slopes of its two sides along x and y: one at each corner.
            const double top = (topRight - topLeft) / pitchX_;
            const double bottom = (bottomRight - bottomLeft) / pitchX_;
            const double left = (topLeft - bottomLeft) / pitchY_;
            const double right = (topRight - bottomRight) / pitchY_;
            gradientOfRow += 0.5 * (top * top + bottom * bottom + left * left + right * right);
            surplusOfRow += 0.25 * (surplus(top, left) + surplus(top, right) +
                                    surplus(bottom, left) + surplus(bottom, right));
            ++count;
        }
        surplusSum_ += surplusOfRow;
        gradientSum_ += gradientOfRow;
    }

    [[nodiscard]] double sdr() const { return meanOf(surplusSum_); }
    [[nodiscard]] double sdq() const { return std::sqrt(meanOf(gradientSum_)); }

    std::size_t count = 0;

private:
    /// 0 without a square.
    [[nodiscard]] double meanOf(double sum) const {
        return count == 0 ? 0.0 : sum / static_cast<double>(count);
    }

    /// sqrt(1 + s^2) - 1, without loss for small slopes.
    static double surplus(double slopeX, double slopeY) {
        const double square = slopeX * slopeX + slopeY * slopeY;
        return square / (std::sqrt(1.0 + square) + 1.0);
    }

    double pitchX_;             ///< [m]
    double pitchY_;             ///< [m]
    double surplusSum_ = 0.0;   ///< of surface over outline - 1
    double gradientSum_ = 0.0;  ///< of squares of the gradient
};

void requireInside(const HeightRows& map, const PixelRectangle& pixels) {
    if (!pixels.liesIn(map.columns, map.rows)) {
        throw Error("the rectangle reaches out of the scan");
    }
}

/// First pixel and number of those whose centers lie from `low` to `high` [pixel].
std::pair<int, int> centersBetween(double low, double high, int count) {
    const double first = std::max(std::ceil(low - 0.5), 0.0);
    const double last = std::min(std::floor(high - 0.5), count - 1.0);
    if (!(first <= last)) {
        throw Error("the rectangle holds no pixel of the scan");
    }
    return {static_cast<int>(first), static_cast<int>(last - first) + 1};
}

}  // namespace

PixelRectangle allPixels(const HeightRows& map) {
    return {.column = 0, .row = 0, .columns = map.columns, .rows = map.rows};
}

PixelRectangle pixelsBetween(const HeightRows& map, const Vector2& corner,
                             const Vector2& opposite) {
    if (!isFinite(corner) || !isFinite(opposite)) {
        throw Error("the corners of the rectangle must be finite numbers of meters");
    }
    const Vector2 low = corner.cwiseMin(opposite);
    const Vector2 high = corner.cwiseMax(opposite);
    const auto [left, columns] =
        centersBetween(low.x() / map.pitchX, high.x() / map.pitchX, map.columns);
    const auto [bottom, rows] =
        centersBetween(low.y() / map.pitchY, high.y() / map.pitchY, map.rows);
    return {.column = left, .row = map.rows - bottom - rows, .columns = columns, .rows = rows};
}

Roughness roughnessOf(const HeightRows& map, const PixelRectangle& pixels, Progress* progress) {
    requireInside(map, pixels);
    RectangleRows rows(map, pixels);
    Heights heights;
    ProgressPart first(progress, 0.0, 0.4);
    rows.forEach(&first, [&](const auto& row, const auto& /*above*/) { heights.add(row); });
    if (heights.count == 0) {
        throw Error("no pixel of the rectangle holds data");
    }
    const double mean = heights.mean();
    Deviations deviations;
    SquareSums squares(map.pitchX, map.pitchY);
    ProgressPart second(progress, 0.4, 1.0);
    rows.forEach(&second, [&](const auto& row, const auto& above) {
        deviations.add(row, mean);
        squares.add(row, above);
    });
    const auto count = static_cast<double>(heights.count);
    // What single precision leaves of a mean that leveling removed is no height.
    constexpr double kRounding = std::numeric_limits<float>::epsilon();
    const double extent = heights.highest - heights.lowest;
    Roughness roughness{.sa = deviations.absolute / count,
                        .sq = std::sqrt(deviations.square / count),
                        .sz = extent,
                        .sp = heights.highest - mean,
                        .sv = mean - heights.lowest,
                        .ssk = std::nullopt,
                        .sku = std::nullopt,
                        .sdq = squares.sdq(),
                        .sdr = squares.sdr(),
                        .mean = std::abs(mean) < kRounding * extent ? 0.0 : mean,
                        .lowest = heights.lowest,
                        .highest = heights.highest,
                        .pixels = heights.count,
                        .squares = squares.count};
    if (extent > 0.0) {
        const double square = roughness.sq * roughness.sq;
        roughness.ssk = deviations.cube / count / (square * roughness.sq);
        roughness.sku = deviations.fourth / count / (square * square);
    }
    return roughness;
}

HeightHistogram histogramOf(const HeightRows& map, const PixelRectangle& pixels,
                            const Roughness& roughness, Progress* progress) {
    constexpr std::size_t kBins = 128;
    const double extent = roughness.highest - roughness.lowest;
    HeightHistogram histogram{.lowest = roughness.lowest,
                              .width = extent / static_cast<double>(kBins),
                              .counts = std::vector<std::size_t>(extent > 0.0 ? kBins : 1)};
    const std::size_t last = histogram.counts.size() - 1;
    const double scale = extent > 0.0 ? static_cast<double>(kBins) / extent : 0.0;
    RectangleRows(map, pixels).forEach(progress, [&](const auto& row, const auto& /*above*/) {
        for (const double height : row) {
            if (isFiniteHeight(height)) {
                const auto bin = static_cast<std::size_t>(scale * (height - histogram.lowest));
                ++histogram.counts[std::min(bin, last)];
            }
        }
    });
    return histogram;
}

HeightRows rowsOf(const BSplineSurface& surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    return {.columns = grid.columns,
            .rows = grid.rows,
            .pitchX = grid.pitchX,
            .pitchY = grid.pitchY,
            .readRow = [&surface](int row, double* heights) {
                const BSplineSurface::Grid& pixels = surface.grid();
                const double y = (pixels.rows - row - 0.5) * pixels.pitchY;
                for (int column = 0; column < pixels.columns; ++column) {
                    const double x = (column + 0.5) * pixels.pitchX;
                    heights[column] = surface.isMeasured(x, y)
                                          ? surface.at(x, y).height
                                          : std::numeric_limits<double>::quiet_NaN();
                }
            }};
}

}  // namespace asperity
