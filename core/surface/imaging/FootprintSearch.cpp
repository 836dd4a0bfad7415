#include "core/surface/imaging/FootprintSearch.h"

#include "core/Error.h"
#include "core/ShareOut.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace asperity {

namespace {

constexpr double kAboveAll = std::numeric_limits<double>::infinity();
/// Rounding must not make a bound cut off what it bounds.
constexpr double kFootprintRounding = 8.0 * std::numeric_limits<double>::epsilon();

/// Whole pixels within `length`, at most those of a line of `count` pixels.
int pixelsWithin(double length, int count) {
    return static_cast<int>(std::min(std::floor(length), count - 1.0));
}

double usableRadius(double radius) {
    if (!std::isfinite(radius) || radius <= 0.0) {
        throw Error("the radius of the imaging tip must be a positive number of meters");
    }
    return radius;
}

/// Blocks that pixels `reach` apart can span.
int blocksWithin(int reach) { return (reach + kFootprintBlock - 1) / kFootprintBlock; }

constexpr double kNoHeight = -std::numeric_limits<double>::infinity();

int blocksOf(int pixels) { return (pixels + kFootprintBlock - 1) / kFootprintBlock; }

}  // namespace

TipFootprint::TipFootprint(const Grid& grid, double tipRadius)
    : pitchX_(grid.pitchX)
    , pitchY_(grid.pitchY)
    , radius_(usableRadius(tipRadius))
    , wholeReachX_(std::floor(radius_ / pitchX_))
    , wholeReachY_(std::floor(radius_ / pitchY_))
    , reachX_(pixelsWithin(wholeReachX_, grid.columns))
    , reachY_(pixelsWithin(wholeReachY_, grid.rows))
    , blockReachX_(blocksWithin(reachX_))
    , blockReachY_(blocksWithin(reachY_))
    , middle_((blockReachX_ + 1) * kFootprintBlock)
    , stride_(static_cast<std::size_t>(2 * middle_ + kFootprintBlock)) {
    fillRises();
    fillBlockRises();
}

/// R - sqrt(R^2 - d^2), written so that nothing cancels close to the apex.
double TipFootprint::riseAt(int row, int column) const {
    const double distance = std::hypot(column * pitchX_, row * pitchY_);
    if (distance > radius_) {
        return kAboveAll;
    }
    const double depth = std::sqrt((radius_ - distance) * (radius_ + distance));
    return distance * (distance / (radius_ + depth));
}

void TipFootprint::fillRises() {
    rises_.assign(static_cast<std::size_t>(reachY_ + 1) * stride_, kAboveAll);
    for (int row = 0; row <= reachY_; ++row) {
        double* apex = rises_.data() + static_cast<std::size_t>(row) * stride_ + middle_;
        for (int column = 0; column <= reachX_; ++column) {
            apex[column] = riseAt(row, column);
            apex[-column] = apex[column];
        }
    }
}

void TipFootprint::fillBlockRises() {
    const auto nearest = [](int blocks) {
        return std::max(blocks * kFootprintBlock - (kFootprintBlock - 1), 0);
    };
    const auto farthest = [](int blocks) { return (blocks + 1) * kFootprintBlock - 1; };
    for (int up = 0; up <= blockReachY_; ++up) {
        for (int across = 0; across <= blockReachX_; ++across) {
            leastRises_.push_back(riseAt(nearest(up), nearest(across)) *
                                  (1.0 - kFootprintRounding));
            greatestRises_.push_back(riseAt(farthest(up), farthest(across)) *
                                     (1.0 + kFootprintRounding));
        }
    }
}

bool TipFootprint::isWithin(const Grid& grid, int row, int column) const {
    return std::min(column, grid.columns - 1 - column) >= wholeReachX_ &&
           std::min(row, grid.rows - 1 - row) >= wholeReachY_;
}

/// The first pixel found to reach the level of one apex position, and how many do; 2: two or more.
template <class Heights>
struct FootprintSearch<Heights>::Touches {
    Pixel first;
    int count = 0;
};

template <class Heights>
FootprintSearch<Heights>::FootprintSearch(const Grid& grid, const Source& heights, double tipRadius)
    : grid_(grid)
    , tip_(grid, tipRadius)
    , blockColumns_(blocksOf(grid.columns))
    , blockRows_(blocksOf(grid.rows))
    , heights_(heights) {
    const std::size_t blocks =
        static_cast<std::size_t>(blockColumns_) * static_cast<std::size_t>(blockRows_);
    blockHeights_.assign(blocks, kNoHeight);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            if (heights_.counts(index(row, column))) {
                double& highest =
                    blockHeights_[blockIndex(row / kFootprintBlock, column / kFootprintBlock)];
                highest = std::max(highest, heights_.at(index(row, column)));
            }
        }
    }
}

/// Blocks that hold any height, as far as the tip reaches from the tile.
template <class Heights>
template <class Visit>
void FootprintSearch<Heights>::forEachBlockAround(const Tile& tile, const Visit& visit) const {
    const int lowRow = std::max(tile.row - tip_.blockReachY(), 0);
    const int highRow = std::min(tile.row + tip_.blockReachY(), blockRows_ - 1);
    const int lowColumn = std::max(tile.column - tip_.blockReachX(), 0);
    const int highColumn = std::min(tile.column + tip_.blockReachX(), blockColumns_ - 1);
    for (int row = lowRow; row <= highRow; ++row) {
        for (int column = lowColumn; column <= highColumn; ++column) {
            if (blockHeights_[blockIndex(row, column)] != kNoHeight) {
                visit(row, column);
            }
        }
    }
}

template <class Heights>
template <class Visit>
void FootprintSearch<Heights>::forEachPixel(const Tile& tile, const Visit& visit) const {
    const int top = tile.row * kFootprintBlock;
    const int left = tile.column * kFootprintBlock;
    for (int row = top; row < std::min(top + kFootprintBlock, grid_.rows); ++row) {
        for (int column = left; column < std::min(left + kFootprintBlock, grid_.columns);
             ++column) {
            visit(row, column);
        }
    }
}

template <class Heights>
template <class Work>
void FootprintSearch<Heights>::forEachTile(Progress* progress, const Work& work) const {
    shareOut(blockRows_, progress, [&](int row, const CancelCheck& check) {
        Tile tile{.row = row, .column = 0, .candidates = {}, .heights = {}};
        for (; tile.column < blockColumns_; ++tile.column) {
            check();
            work(tile);
        }
    });
}

/// Returns the least that every position of the tile finds.
template <class Heights>
double FootprintSearch<Heights>::floorOf(const Tile& tile) const {
    double floor = kNoHeight;
    forEachBlockAround(tile, [&](int row, int column) {
        const double rise = tip_.greatestRise(row - tile.row, column - tile.column);
        floor = std::max(floor, blockHeights_[blockIndex(row, column)] - rise);
    });
    return floor;
}

template <class Heights>
void FootprintSearch<Heights>::findCandidates(Tile& tile, double floor) const {
    tile.candidates.clear();
    tile.heights.clear();
    forEachBlockAround(tile, [&](int row, int column) {
        const double rise = tip_.leastRise(row - tile.row, column - tile.column);
        const double bound = blockHeights_[blockIndex(row, column)] - rise;
        if (bound != kNoHeight && bound >= floor) {
            tile.candidates.push_back(
                {.bound = bound, .row = row * kFootprintBlock, .column = column * kFootprintBlock});
        }
    });
    std::ranges::sort(tile.candidates, std::ranges::greater(), &Block::bound);
}

template <class Heights>
typename FootprintSearch<Heights>::BlockHeights
FootprintSearch<Heights>::heightsIn(const Block& block) const {
    BlockHeights heights;
    for (int row = 0; row < kFootprintBlock; ++row) {
        for (int column = 0; column < kFootprintBlock; ++column) {
            double& height =
                heights[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
            height = kNoHeight;
            if (block.row + row < grid_.rows && block.column + column < grid_.columns) {
                const std::size_t pixel = index(block.row + row, block.column + column);
                height = heights_.counts(pixel) ? heights_.at(pixel) : kNoHeight;
            }
        }
    }
    return heights;
}

template <class Heights>
const typename FootprintSearch<Heights>::BlockHeights&
FootprintSearch<Heights>::heightsOf(Tile& tile, Block& block) const {
    if (block.heights == kUnread) {
        block.heights = tile.heights.size();
        tile.heights.push_back(heightsIn(block));
    }
    return tile.heights[block.heights];
}

/// Eight lanes, each with its own maximum: a form that compilers turn into vector instructions.
template <class Heights>
double FootprintSearch<Heights>::bestOf(const BlockHeights& heights, const Block& block,
                                        Pixel apex) const {
    Lanes best;
    best.fill(kNoHeight);
    const int first = std::max(block.row, apex.row - tip_.reachY());
    const int last = std::min(block.row + kFootprintBlock - 1, apex.row + tip_.reachY());
    for (int from = first; from <= last; ++from) {
        const Lanes& row = heights[static_cast<std::size_t>(from - block.row)];
        const double* rises = tip_.risesFrom(from - apex.row, block.column - apex.column);
        for (std::size_t lane = 0; lane < best.size(); ++lane) {
            const double height = row[lane] - rises[lane];
            best[lane] = height > best[lane] ? height : best[lane];
        }
    }
    return *std::ranges::max_element(best);
}

template <class Heights>
double FootprintSearch<Heights>::bestFor(Tile& tile, Pixel apex) const {
    double best = kNoHeight;
    for (Block& block : tile.candidates) {
        if (block.bound <= best) {
            break;
        }
        best = std::max(best, bestOf(heightsOf(tile, block), block, apex));
    }
    return best;
}

template <class Heights>
template <class Value>
Heights FootprintSearch<Heights>::eachOf(Progress* progress, const Value& value) const {
    using Height = typename Heights::value_type;
    Heights result(index(grid_.rows, 0));
    forEachTile(progress, [&](Tile& tile) {
        findCandidates(tile, floorOf(tile));
        forEachPixel(tile, [&](int row, int column) {
            result[index(row, column)] = static_cast<Height>(value(tile, Pixel{row, column}));
        });
    });
    return result;
}

template <class Heights>
Heights FootprintSearch<Heights>::highest(Progress* progress) const {
    return eachOf(progress, [this](Tile& tile, Pixel apex) { return bestFor(tile, apex); });
}

/// Height less rise; minus infinity where there is none.
template <class Heights>
double FootprintSearch<Heights>::sumAt(Pixel apex, int row, int column) const {
    const bool isInside = row >= 0 && row < grid_.rows && column >= 0 && column < grid_.columns &&
                          std::abs(row - apex.row) <= tip_.reachY();
    return isInside && heights_.counts(index(row, column))
               ? heights_.at(index(row, column)) -
                     *tip_.risesFrom(row - apex.row, column - apex.column)
               : kNoHeight;
}

/// Returns how far the top lies above the highest pixel; 0 where the eight around it have none.
template <class Heights>
double FootprintSearch<Heights>::topAbove(Pixel apex, Pixel highest) const {
    std::array<Lanes, 3> sums{};
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double sum = sumAt(apex, highest.row + i - 1, highest.column + j - 1);
            if (sum == kNoHeight) {
                return 0.0;
            }
            sums[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = sum;
        }
    }
    const double x = 0.5 * (sums[1][2] - sums[1][0]);
    const double y = 0.5 * (sums[2][1] - sums[0][1]);
    const double xx = sums[1][2] - (2.0 * sums[1][1]) + sums[1][0];
    const double yy = sums[2][1] - (2.0 * sums[1][1]) + sums[0][1];
    const double xy = 0.25 * (sums[2][2] - sums[2][0] - sums[0][2] + sums[0][0]);
    const double determinant = (xx * yy) - (xy * xy);
    if (!(xx < 0.0) || !(determinant > 0.0)) {
        return 0.0;
    }
    const double right = ((xy * y) - (yy * x)) / determinant;  // [pixel]
    const double down = ((xy * x) - (xx * y)) / determinant;
    return std::max(std::abs(right), std::abs(down)) <= 1.0 ? 0.5 * ((x * right) + (y * down))
                                                            : 0.0;
}

template <class Heights>
Heights FootprintSearch<Heights>::highestBetweenPixels(Progress* progress) const {
    return eachOf(progress, [this](Tile& tile, Pixel apex) {
        const double best = bestFor(tile, apex);
        return best == kNoHeight ? best : best + topAbove(apex, touchesOf(tile, apex, best).first);
    });
}

template <class Heights>
void FootprintSearch<Heights>::collect(const BlockHeights& heights, const Block& block, Pixel apex,
                                       double level, Touches& touches) const {
    const int first = std::max(block.row, apex.row - tip_.reachY());
    const int last = std::min(block.row + kFootprintBlock - 1, apex.row + tip_.reachY());
    for (int from = first; from <= last; ++from) {
        const Lanes& row = heights[static_cast<std::size_t>(from - block.row)];
        const double* rises = tip_.risesFrom(from - apex.row, block.column - apex.column);
        for (std::size_t lane = 0; lane < row.size(); ++lane) {
            if (row[lane] - rises[lane] < level) {
                continue;
            }
            if (++touches.count > 1) {
                return;
            }
            touches.first = {from, block.column + static_cast<int>(lane)};
        }
    }
}

template <class Heights>
typename FootprintSearch<Heights>::Touches
FootprintSearch<Heights>::touchesOf(Tile& tile, Pixel apex, double level) const {
    Touches touches;
    for (Block& block : tile.candidates) {
        if (block.bound < level || touches.count > 1) {
            break;
        }
        const BlockHeights& heights = heightsOf(tile, block);
        if (bestOf(heights, block, apex) >= level) {
            collect(heights, block, apex, level, touches);
        }
    }
    return touches;
}

template <class Heights>
std::vector<std::uint8_t> FootprintSearch<Heights>::reachingAlone(const Source& levels,
                                                                  double tolerance,
                                                                  Progress* progress) const {
    std::vector<std::uint8_t> alone(index(grid_.rows, 0), 0);
    const auto hasLevel = [&](Pixel pixel) {
        return levels.counts(index(pixel.row, pixel.column));
    };
    const auto levelOf = [&](int row, int column) {
        return levels.at(index(row, column)) - tolerance;
    };
    const auto isUsable = [&](int row, int column) {
        return tip_.isWithin(grid_, row, column) && hasLevel({row, column});
    };
    forEachTile(progress, [&](Tile& tile) {
        double floor = -kNoHeight;
        forEachPixel(tile, [&](int row, int column) {
            if (isUsable(row, column)) {
                floor = std::min(floor, levelOf(row, column));
            }
        });
        if (floor == -kNoHeight) {
            return;
        }
        findCandidates(tile, floor);
        forEachPixel(tile, [&](int row, int column) {
            if (!isUsable(row, column)) {
                return;
            }
            const Touches touches = touchesOf(tile, {row, column}, levelOf(row, column));
            if (touches.count == 1 && hasLevel(touches.first)) {
                // Two threads may mark the same pixel.
                std::atomic_ref(alone[index(touches.first.row, touches.first.column)])
                    .store(1, std::memory_order_relaxed);
            }
        });
    });
    return alone;
}

template class FootprintSearch<std::vector<double>>;
template class FootprintSearch<PixelVector<float>>;

}  // namespace asperity
