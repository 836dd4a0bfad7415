#pragma once

#include "core/surface/BSplineSurface.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Heights of a rectangle of a surface, all together: the plane nearest to them, by least squares.
struct HeightSpread {
    double mean = 0.0;  ///< in the rectangle's middle [m]
    double slopeX = 0.0;
    double slopeY = 0.0;
    double variance = 0.0;  ///< around the plane [m^2]
};

/// Planes through a height field over blocks of 2 x 2, 4 x 4, 8 x 8 ... pixels, for sums over the
/// surface that need no detail where it is far away. Some 5 bytes a pixel. Immutable.
class HeightMoments {
public:
    explicit HeightMoments(const BSplineSurface& surface);

    /// Plane of the block of 2^level pixels a side, level >= 1, rows from the bottom; a block
    /// beyond the scan is level, and as high and rough as the nearest one on it; one larger than
    /// the scan is as the whole scan.
    [[nodiscard]] HeightSpread at(int level, int row, int column) const noexcept;
    [[nodiscard]] const BSplineSurface& surface() const noexcept { return surface_; }

private:
    struct Entry {
        float mean = 0.0F;  ///< above the grid's datum [m]
        float slopeX = 0.0F;
        float slopeY = 0.0F;
        float variance = 0.0F;  ///< [m^2]
    };
    struct Level {
        int columns = 0;
        int rows = 0;
        std::vector<Entry> entries;  ///< row-major, bottom row first
    };

    template <class SpreadAt>
    static Level halved(int rows, int columns, double width, double height,
                        const SpreadAt& spreadAt);

    BSplineSurface surface_;
    std::vector<Level> levels_;  ///< from 2 x 2 pixels to a single block
};

}  // namespace asperity
