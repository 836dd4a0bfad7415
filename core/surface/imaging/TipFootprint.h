#pragma once

#include <cstddef>
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

    /// Least rise between any two pixels of blocks that lie so many blocks apart [m].
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
    /// Whether the whole tip lies over the map when its apex is over this pixel.
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

}  // namespace asperity
