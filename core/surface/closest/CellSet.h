#pragma once

#include "core/surface/closest/BoundsWindow.h"
#include "core/surface/closest/CellIndex.h"

#include <array>
#include <bit>
#include <cstddef>

namespace asperity {

/// Some cells around a place.
class CellSet {
public:
    static constexpr int kSide = BoundsWindow::kMaxBlocks;  ///< no more rows or columns

    /// @param first the lowest row and column there can be
    explicit CellSet(const CellIndex& first) noexcept : first_(first) {}

    void add(const CellIndex& cell) noexcept { rows_[rowOf(cell)] |= bitOf(cell); }
    void remove(const CellIndex& cell) noexcept { rows_[rowOf(cell)] &= ~bitOf(cell); }
    [[nodiscard]] bool holds(const CellIndex& cell) const noexcept {
        return inRange(cell.row - first_.row) && inRange(cell.column - first_.column) &&
               (rows_[rowOf(cell)] & bitOf(cell)) != 0;
    }
    /// Calls take(CellIndex) for each.
    template <class Take>
    void forEach(const Take& take) const {
        for (int row = 0; row < kSide; ++row) {
            for (BoundsWindow::Bits left = rows_[static_cast<std::size_t>(row)]; left != 0;
                 left &= left - 1) {
                take(CellIndex{.row = first_.row + row,
                               .column = first_.column + std::countr_zero(left)});
            }
        }
    }

private:
    static bool inRange(int offset) noexcept { return offset >= 0 && offset < kSide; }
    [[nodiscard]] std::size_t rowOf(const CellIndex& cell) const noexcept {
        return static_cast<std::size_t>(cell.row - first_.row);
    }
    [[nodiscard]] BoundsWindow::Bits bitOf(const CellIndex& cell) const noexcept {
        return BoundsWindow::Bits{1} << static_cast<unsigned>(cell.column - first_.column);
    }

    CellIndex first_;
    std::array<BoundsWindow::Bits, kSide> rows_{};
};

}  // namespace asperity
