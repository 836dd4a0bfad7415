#pragma once

#include "core/surface/BSplineSurface.h"

#include <algorithm>
#include <cmath>

namespace asperity {

/// A run of blocks along one axis.
struct BlockRun {
    int first = 0;
    int count = 0;
};

/// Blocks of `cells` cells along one axis of a surface.
struct BlockAxis {
    int pixels = 0;
    int blocks = 0;
    int cells = 1;
    double pitch = 0.0;  ///< [m]

    [[nodiscard]] int at(double place) const {
        const double block = (place / pitch - 0.5) / cells;
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
        const double away = std::max({low(block) - place, place - high(block), 0.0});
        return away * away;
    }
};

inline int cellsPerBlock(int level) {
    int cells = 1;
    for (int i = 0; i < level; ++i) {
        cells *= CellBounds::kFactor;
    }
    return cells;
}

inline BlockAxis blocksAlongX(const BSplineSurface& surface, int level) {
    return {.pixels = surface.grid().columns,
            .blocks = surface.bounds().level(level).columns,
            .cells = cellsPerBlock(level),
            .pitch = surface.grid().pitchX};
}

inline BlockAxis blocksAlongY(const BSplineSurface& surface, int level) {
    return {.pixels = surface.grid().rows,
            .blocks = surface.bounds().level(level).rows,
            .cells = cellsPerBlock(level),
            .pitch = surface.grid().pitchY};
}

}  // namespace asperity
