#include "core/surface/imaging/TipFootprint.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace asperity
