#pragma once

#include "core/Progress.h"
#include "core/surface/imaging/TipFootprint.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// For every pixel of a map, searches the map's heights less the tip's rise there, over the tip's
/// footprint around the pixel. Heights of minus infinity take no part.
///
/// Blocks of pixels are visited in the order of what they can give at best, and no longer than that
/// can matter, so that of a wide footprint only few pixels are looked at. Rows of blocks are shared
/// out among threads; results do not depend on their number.
class FootprintSearch {
public:
    using Grid = TipFootprint::Grid;

    /// @param heights rows x columns, row-major [m]
    /// @throw Error when the radius is not a positive length
    FootprintSearch(const Grid& grid, const std::vector<double>& heights, double tipRadius);

    /// The highest of heights less rises for each pixel; minus infinity where there is none [m].
    /// @throw Cancelled
    [[nodiscard]] std::vector<double> highest(Progress* progress = nullptr) const;

    /// 1 where a pixel is the only one, but for direct neighbours, to reach up to the level of some
    /// place of the apex. Places where part of the tip lies beyond the map's edge tell nothing, nor
    /// do those without a level, or that a pixel without a level reaches.
    /// @param levels of each pixel, minus infinity for none [m]
    /// @throw Cancelled
    [[nodiscard]] std::vector<std::uint8_t> reachingAlone(const std::vector<double>& levels,
                                                          Progress* progress = nullptr) const;

private:
    struct Pixel {
        int row = 0;
        int column = 0;
    };
    struct Block {
        double bound = 0.0;  ///< nothing in the block gives more [m]
        int row = 0;         ///< of its first pixel
        int column = 0;      ///< of its first pixel
    };
    /// A block of apex places, and the blocks that can matter to them, best first.
    struct Tile {
        int row = 0;
        int column = 0;
        std::vector<Block> candidates;
    };
    class Touches;

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] std::size_t paddedIndex(int row, int column) const {
        const int stride = blockColumns_ * kFootprintBlock;
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(stride) +
               static_cast<std::size_t>(column);
    }
    [[nodiscard]] std::size_t blockIndex(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(blockColumns_) +
               static_cast<std::size_t>(column);
    }
    template <class Visit>
    void forEachBlockAround(const Tile& tile, const Visit& visit) const;
    template <class Visit>
    void forEachPixel(const Tile& tile, const Visit& visit) const;
    template <class Work>
    void forEachTile(Progress* progress, const Work& work) const;
    [[nodiscard]] double floorOf(const Tile& tile) const;
    void findCandidates(Tile& tile, double floor) const;
    [[nodiscard]] double bestOf(const Block& block, int row, int column) const;
    [[nodiscard]] double bestFor(const Tile& tile, int row, int column) const;
    [[nodiscard]] Touches touchesOf(const Tile& tile, int row, int column, double level) const;
    void collect(const Block& block, int row, int column, double level, Touches& touches) const;

    Grid grid_;
    TipFootprint tip_;
    int blockColumns_;
    int blockRows_;
    std::vector<double> heights_;       ///< padded to whole blocks [m]
    std::vector<double> blockHeights_;  ///< highest pixel of each block [m]
};

}  // namespace asperity
