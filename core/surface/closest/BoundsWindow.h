#pragma once

#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// A run of blocks along one axis.
struct BlockRun {
    int first = 0;
    int count = 0;

    [[nodiscard]] int end() const { return first + count; }
    [[nodiscard]] bool holds(int block) const { return block >= first && block < end(); }
};

/// Blocks of `cells` cells along one axis of a surface.
struct BlockAxis {
    int pixels = 0;
    int blocks = 0;
    int cells = 1;
    double pitch = 0.0;     ///< [m]
    double perPitch = 0.0;  ///< 1 / pitch [1/m]
    double perCells = 1.0;  ///< 1 / cells

    [[nodiscard]] int at(double position) const {
        const double block = (position * perPitch - 0.5) * perCells;
        return std::isgreater(block, 0.0)
                   ? static_cast<int>(std::min(block, static_cast<double>(blocks - 1)))
                   : 0;
    }
    [[nodiscard]] double low(int block) const {
        return block == 0 ? 0.0 : (block * cells + 0.5) * pitch;
    }
    [[nodiscard]] double high(int block) const {
        return block == blocks - 1 ? pixels * pitch : ((block + 1) * cells + 0.5) * pitch;
    }
    [[nodiscard]] BlockRun within(double position, double reach) const {
        const int first = at(position - reach);
        return {.first = first, .count = at(position + reach) - first + 1};
    }
    /// Squared distance from a position to a block along the axis [m^2].
    [[nodiscard]] double squaredDistance(double position, int block) const {
        const double away = std::max(std::max(low(block) - position, position - high(block)), 0.0);
        return away * away;
    }
};

inline BlockAxis blockAxis(int pixels, int blocks, int level, double pitch) {
    int cells = 1;
    for (int i = 0; i < level; ++i) {
        cells *= CellBounds::kFactor;
    }
    return {.pixels = pixels,
            .blocks = blocks,
            .cells = cells,
            .pitch = pitch,
            .perPitch = 1.0 / pitch,
            .perCells = 1.0 / cells};
}

inline BlockAxis blocksAlongX(const BSplineSurface& surface, int level) {
    const BSplineSurface::Grid& grid = surface.grid();
    return blockAxis(grid.columns, surface.bounds().level(level).columns, level, grid.pitchX);
}

inline BlockAxis blocksAlongY(const BSplineSurface& surface, int level) {
    const BSplineSurface::Grid& grid = surface.grid();
    return blockAxis(grid.rows, surface.bounds().level(level).rows, level, grid.pitchY);
}

/// Some blocks of a window, counted from its first row and column.
struct WindowBlocks {
    BlockRun rows;
    BlockRun columns;
};

/// Bounds of the blocks within some distance of a point: how near each can come to it, and how far
/// the squared distance from it is from having a second minimum there. Allocation-free.
class BoundsWindow {
public:
    static constexpr int kMaxBlocks = 64;  ///< along an axis
    using Bits = std::uint64_t;            ///< one a block of a row

    /// @param distance blocks that cannot hold a point within it are left out [m]
    /// @param ball what is settled is so for all queries within this distance of `query` [m]
    BoundsWindow(const BSplineSurface& surface, const Vector3& query, double distance,
                 double ball = 0.0) noexcept;

    [[nodiscard]] int level() const noexcept { return level_; }
    [[nodiscard]] const BlockRun& rows() const noexcept { return rows_; }
    [[nodiscard]] const BlockRun& columns() const noexcept { return columns_; }

    /// Bit k: block k of the row can hold a point within the window's distance. Rows and blocks are
    /// counted from the window's first.
    [[nodiscard]] Bits reaching(int row) const noexcept {
        return reaching_[static_cast<std::size_t>(row)];
    }
    /// Returns whether a block can hold a point within `distance` [m].
    [[nodiscard]] bool reaches(int row, int column, double distance) const noexcept {
        return nearest_[index(row, column)] <= squaredWithRounding(distance);
    }

    /// Returns the largest offset along either axis, in blocks of the window, within which the
    /// distance from a local minimum in this block can only grow; -1: none.
    [[nodiscard]] int settledAround(int row, int column) const noexcept;
    [[nodiscard]] int rowAt(double y) const noexcept;     ///< counted from the window's first
    [[nodiscard]] int columnAt(double x) const noexcept;  ///< counted from the window's first
    /// The blocks within `reach` of (x, y) along either axis [m].
    [[nodiscard]] WindowBlocks blocksAround(double x, double y, double reach) const noexcept;

private:
    static constexpr std::size_t kMaxWindow = std::size_t{kMaxBlocks} * kMaxBlocks;

    [[nodiscard]] static std::size_t index(int row, int column) noexcept {
        return static_cast<std::size_t>(row) * kMaxBlocks + static_cast<std::size_t>(column);
    }
    [[nodiscard]] float squaredWithRounding(double distance) const noexcept;
    [[nodiscard]] int widestOffset(int row, int column) const noexcept;
    [[nodiscard]] float leastBend(int row, int column, int offset) const noexcept;

    BlockAxis x_;
    BlockAxis y_;
    int level_ = 0;
    BlockRun rows_;
    BlockRun columns_;
    double rounding_ = 0.0;                  ///< of a height difference [m]
    std::array<Bits, kMaxBlocks> reaching_;  ///< of each row
    std::array<float, kMaxWindow> nearest_;  ///< squared distance, at least [m^2]
    /// The squared distance along a straight line through the block bends up at least so much, as a
    /// share of that from a level plane; 1 or less, < 0: it may bend down.
    std::array<float, kMaxWindow> bend_;
};

}  // namespace asperity
