#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace asperity {

/// Pixels are taken together in square blocks of this side, so that most of a footprint can be
/// passed over by the highest pixel of each block.
inline constexpr int kFootprintBlock = 8;

/// A spherical tip sampled on a pixel grid: how far its surface lies above its apex, `offset`
/// pixels away from it. Infinite beyond the tip's radius.
class TipFootprint {
public:
    struct Grid {
        int columns = 0;
        int rows = 0;
        double pitchX = 0.0;  ///< [m]
        double pitchY = 0.0;  ///< [m]
    };

    /// The part of the tip that can matter on a map of this size.
    /// @throw Error when the radius is not a positive length
    TipFootprint(const Grid& grid, double tipRadius);

    /// Rises for the pixel offsets column, column + 1, ... up to kFootprintBlock of them [m]; row
    /// within -reachY()..reachY(), column at most kFootprintBlock beyond a block that blockReachX()
    /// admits.
    [[nodiscard]] const double* risesFrom(int row, int column) const {
        const int up = row < 0 ? -row : row;
        return rises_.data() + static_cast<std::size_t>(up) * stride_ +
               static_cast<std::size_t>(column + middle_);
    }

    /// Least rise between any two pixels of blocks that are this many blocks apart [m].
    [[nodiscard]] double leastRise(int blockRows, int blockColumns) const {
        return leastRises_[blockIndex(blockRows, blockColumns)];
    }
    /// Greatest rise between any two pixels of such blocks [m].
    [[nodiscard]] double greatestRise(int blockRows, int blockColumns) const {
        return greatestRises_[blockIndex(blockRows, blockColumns)];
    }

    [[nodiscard]] int reachY() const { return reachY_; }  ///< [pixel]
    [[nodiscard]] int blockReachX() const { return blockReachX_; }
    [[nodiscard]] int blockReachY() const { return blockReachY_; }
    /// Returns whether the whole tip lies over the map when its apex is over this pixel.
    [[nodiscard]] bool isWithin(const Grid& grid, int row, int column) const;

private:
    [[nodiscard]] double riseAt(int row, int column) const;
    [[nodiscard]] std::size_t blockIndex(int rows, int columns) const {
        const int up = rows < 0 ? -rows : rows;
        const int across = columns < 0 ? -columns : columns;
        return static_cast<std::size_t>(up) * static_cast<std::size_t>(blockReachX_ + 1) +
               static_cast<std::size_t>(across);
    }
    void fillRises();
    void fillBlockRises();

    double pitchX_;       ///< [m]
    double pitchY_;       ///< [m]
    double radius_;       ///< [m]
    double wholeReachX_;  ///< of the tip, on however large a map [pixel]
    double wholeReachY_;  ///< [pixel]
    int reachX_;          ///< on this map [pixel]
    int reachY_;          ///< [pixel]
    int blockReachX_;
    int blockReachY_;
    int middle_;                         ///< of a row of rises_
    std::size_t stride_;                 ///< of rises_
    std::vector<double> rises_;          ///< rows 0..reachY_, columns of either sign [m]
    std::vector<double> leastRises_;     ///< [m]
    std::vector<double> greatestRises_;  ///< [m]
};

/// Heights that are searched where they lie. Those that are masked or not finite take no part.
template <class Heights>
struct SearchedHeights {
    const Heights& values;               ///< rows x columns, row-major [m]
    const PixelMask* invalid = nullptr;  ///< of as many pixels; null or empty: none is masked
    bool isTurned = false;               ///< search the negative of each height

    [[nodiscard]] bool counts(std::size_t pixel) const {
        return (invalid == nullptr || invalid->empty() || !(*invalid)[pixel]) &&
               isFiniteHeight(values[pixel]);
    }
    /// Height of a pixel that counts [m].
    [[nodiscard]] double at(std::size_t pixel) const {
        const auto value = static_cast<double>(values[pixel]);
        return isTurned ? -value : value;
    }
};

/// For every pixel of a map, searches the map's heights less the tip's rise there, over the tip's
/// footprint around the pixel. Computed in double precision, whatever the heights are stored in.
///
/// Blocks of pixels are visited in the order of what they can give at best, and no longer than that
/// can matter, so that of a wide footprint only few pixels are looked at. Rows of blocks are shared
/// out among threads; results do not depend on their number.
template <class Heights>
class FootprintSearch {
public:
    using Grid = TipFootprint::Grid;
    using Source = SearchedHeights<Heights>;

    /// @param heights must outlive the search
    /// @throw Error when the radius is not a positive length
    FootprintSearch(const Grid& grid, const Source& heights, double tipRadius);

    /// The highest of heights less rises for each pixel; minus infinity where there is none [m].
    /// @throw Canceled
    [[nodiscard]] Heights highest(Progress* progress = nullptr) const;

    /// The same between pixels: the top of the paraboloid through the highest and its eight
    /// neighbors, where they have one within a pixel [m]. @throw Canceled
    [[nodiscard]] Heights highestBetweenPixels(Progress* progress = nullptr) const;

    /// Marks with 1 each pixel that is the only one to reach the level of some apex position.
    /// Positions where part of the tip lies beyond the map's edge prove nothing, nor do those
    /// without a level, or whose only pixel has none.
    /// @param levels of each pixel; one that does not count has none
    /// @param tolerance a pixel that stays this far below the level counts as reaching it [m]
    /// @throw Canceled
    [[nodiscard]] std::vector<std::uint8_t> reachingAlone(const Source& levels, double tolerance,
                                                          Progress* progress = nullptr) const;

private:
    static constexpr std::size_t kUnread = std::numeric_limits<std::size_t>::max();

    struct Pixel {
        int row = 0;
        int column = 0;
    };
    struct Block {
        double bound = 0.0;  ///< nothing in the block gives more [m]
        int row = 0;         ///< of its first pixel
        int column = 0;      ///< of its first pixel
        /// Index of its heights in the tile; kUnread until they are looked at.
        std::size_t heights = kUnread;
    };
    using Lanes = std::array<double, kFootprintBlock>;
    /// Minus infinity for what takes no part [m].
    using BlockHeights = std::array<Lanes, kFootprintBlock>;
    /// A block of apex positions, and the blocks that can matter to them, best first.
    struct Tile {
        int row = 0;
        int column = 0;
        std::vector<Block> candidates;
        std::vector<BlockHeights> heights;  ///< of the candidates that were looked at
    };
    struct Touches;

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) +
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
    [[nodiscard]] BlockHeights heightsIn(const Block& block) const;
    const BlockHeights& heightsOf(Tile& tile, Block& block) const;
    [[nodiscard]] double bestOf(const BlockHeights& heights, const Block& block, Pixel apex) const;
    [[nodiscard]] double bestFor(Tile& tile, Pixel apex) const;
    template <class Value>
    [[nodiscard]] Heights eachOf(Progress* progress, const Value& value) const;
    [[nodiscard]] double sumAt(Pixel apex, int row, int column) const;
    [[nodiscard]] double topAbove(Pixel apex, Pixel highest) const;
    [[nodiscard]] Touches touchesOf(Tile& tile, Pixel apex, double level) const;
    void collect(const BlockHeights& heights, const Block& block, Pixel apex, double level,
                 Touches& touches) const;

    Grid grid_;
    TipFootprint tip_;
    int blockColumns_;
    int blockRows_;
    Source heights_;
    std::vector<double> blockHeights_;  ///< highest pixel of each block [m]
};

}  // namespace asperity
