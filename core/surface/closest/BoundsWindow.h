#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/BlockAxis.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace asperity {

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
    /// Whether a block can hold a point within `distance` [m].
    [[nodiscard]] bool reaches(int row, int column, double distance) const noexcept {
        return nearest_[index(row, column)] <= squaredWithRounding(distance);
    }

    /// Of the window's blocks, those in which the distance from a local minimum in this block can
    /// only grow: all whose offset from the minimum's block is at most this along either axis.
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
