#include "core/surface/HeightMoments.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kOfSide = 1.0 / 12.0;  // variance of a position along the side of a rectangle

/// Moments of a pixel's square, from the surface's derivatives in its middle, relative to a datum:
/// of the quadratic that has them.
HeightSpread spreadOfPixel(const BSplineSurface& surface, int row, int column) noexcept {
    const BSplineSurface::Grid& grid = surface.grid();
    const HeightSample middle = surface.at((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY);
    const double x = grid.pitchX * grid.pitchX;
    const double y = grid.pitchY * grid.pitchY;
    const double bendX = x * middle.dxx;
    const double bendY = y * middle.dyy;
    return {.mean = middle.height - grid.datum + (bendX + bendY) / 24.0,
            .slopeX = middle.dx,
            .slopeY = middle.dy,
            .variance =
                (bendX * bendX + bendY * bendY) / 720.0 + x * y * middle.dxy * middle.dxy / 144.0};
}

/// Sums over the parts of a rectangle that lie on the scan, each counted alike.
class PartSums {
public:
    /// @param width, height of a part [m]
    PartSums(double width, double height) noexcept : width_(width), height_(height) {}

    /// @param column, row of the part: 0 or 1
    void add(const HeightSpread& part, int column, int row) noexcept {
        if (count_ == 0) {
            first_ = part.mean;  // heights are taken from it, so that no digits are lost
        }
        const double above = part.mean - first_;
        ++count_;
        mean_ += above;
        slopeX_ += part.slopeX;
        slopeY_ += part.slopeY;
        stepX_ += column == 0 ? -above : above;
        stepY_ += row == 0 ? -above : above;
        squares_ += above * above + part.variance +
                    kOfSide * (square(width_ * part.slopeX) + square(height_ * part.slopeY));
    }

    /// The plane nearest to all. Where a side has one part only, that one's slope counts.
    [[nodiscard]] HeightSpread whole() const noexcept {
        const double share = 1.0 / count_;
        HeightSpread whole{.mean = share * mean_,
                           .slopeX = share * slopeX_,
                           .slopeY = share * slopeY_,
                           .variance = 0.0};
        constexpr int kAll = 4;
        if (count_ == kAll) {
            // Of both parts' slopes, and of the step between their means.
            whole.slopeX = 0.25 * whole.slopeX + 1.5 * share * stepX_ / width_;
            whole.slopeY = 0.25 * whole.slopeY + 1.5 * share * stepY_ / height_;
        }
        const double ofSlope = count_ == kAll ? 4.0 * kOfSide : kOfSide;
        whole.variance = share * squares_ - square(whole.mean) -
                         ofSlope * (square(width_ * whole.slopeX) + square(height_ * whole.slopeY));
        whole.variance = std::max(whole.variance, 0.0);
        whole.mean += first_;
        return whole;
    }

private:
    static double square(double value) noexcept { return value * value; }

    double width_;
    double height_;
    int count_ = 0;
    double first_ = 0.0;
    double mean_ = 0.0;
    double slopeX_ = 0.0;
    double slopeY_ = 0.0;
    double stepX_ = 0.0;
    double stepY_ = 0.0;
    double squares_ = 0.0;
};

}  // namespace

/// A level of blocks of twice the side. @param width, height of the parts [m]
template <class SpreadAt>
HeightMoments::Level HeightMoments::halved(int rows, int columns, double width, double height,
                                           const SpreadAt& spreadAt) {
    Level level{.columns = (columns + 1) / 2, .rows = (rows + 1) / 2, .entries = {}};
    level.entries.reserve(static_cast<std::size_t>(level.rows) *
                          static_cast<std::size_t>(level.columns));
    for (int row = 0; row < level.rows; ++row) {
        for (int column = 0; column < level.columns; ++column) {
            PartSums sums(width, height);
            for (int i = 2 * row; i < std::min(2 * row + 2, rows); ++i) {
                for (int k = 2 * column; k < std::min(2 * column + 2, columns); ++k) {
                    sums.add(spreadAt(i, k), k % 2, i % 2);
                }
            }
            const HeightSpread whole = sums.whole();
            level.entries.push_back({.mean = static_cast<float>(whole.mean),
                                     .slopeX = static_cast<float>(whole.slopeX),
                                     .slopeY = static_cast<float>(whole.slopeY),
                                     .variance = static_cast<float>(whole.variance)});
        }
    }
    return level;
}

HeightMoments::HeightMoments(const BSplineSurface& surface) : surface_(surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    double width = grid.pitchX;
    double height = grid.pitchY;
    levels_.push_back(halved(grid.rows, grid.columns, width, height, [&](int row, int column) {
        return spreadOfPixel(surface, row, column);
    }));
    while (levels_.back().rows > 1 || levels_.back().columns > 1) {
        width *= 2.0;
        height *= 2.0;
        const Level& finer = levels_.back();
        levels_.push_back(
            halved(finer.rows, finer.columns, width, height, [&finer](int row, int column) {
                const Entry& entry = finer.entries[static_cast<std::size_t>(row) *
                                                       static_cast<std::size_t>(finer.columns) +
                                                   static_cast<std::size_t>(column)];
                return HeightSpread{entry.mean, entry.slopeX, entry.slopeY, entry.variance};
            }));
    }
}

HeightSpread HeightMoments::at(int level, int row, int column) const noexcept {
    const std::size_t index = std::min(static_cast<std::size_t>(level - 1), levels_.size() - 1);
    const Level& blocks = levels_[index];
    const auto i = static_cast<std::size_t>(std::clamp(row, 0, blocks.rows - 1));
    const auto k = static_cast<std::size_t>(std::clamp(column, 0, blocks.columns - 1));
    const Entry& entry = blocks.entries[i * static_cast<std::size_t>(blocks.columns) + k];
    const double datum = surface_.grid().datum;
    const bool isOwn = index == static_cast<std::size_t>(level - 1) && row >= 0 &&
                       row < blocks.rows && column >= 0 && column < blocks.columns;
    if (!isOwn) {
        return {.mean = datum + entry.mean, .variance = entry.variance};
    }
    return {datum + entry.mean, entry.slopeX, entry.slopeY, entry.variance};
}

}  // namespace asperity
