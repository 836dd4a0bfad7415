#pragma once

#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <cmath>

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

    [[nodiscard]] int at(double place) const {
        const double block = (place * perPitch - 0.5) * perCells;
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
    [[nodiscard]] BlockRun within(double place, double reach) const {
        const int first = at(place - reach);
        return {.first = first, .count = at(place + reach) - first + 1};
    }
    /// Squared distance from a place to a block along the axis [m^2].
    [[nodiscard]] double squaredDistance(double place, int block) const {
        const double away = std::max(std::max(low(block) - place, place - high(block)), 0.0);
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

}  // namespace asperity
