#include "tests/core/surface/closest/BruteClosestPoints.h"

#include "core/surface/closest/LocalClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace asperity::test {

namespace {

/// Positions searched from: between two samples the distance can fall by little, so that the
/// nearest closest point starts at one of the nearest.
constexpr std::size_t kMaxStarts = 60;

}  // namespace

BruteClosestPoints::BruteClosestPoints(const BSplineSurface& surface, int perPixel)
    : surface_(surface)
    , columns_(surface.grid().columns * perPixel + 1)
    , rows_(surface.grid().rows * perPixel + 1)
    , stepX_(surface.sizeX() / (columns_ - 1))
    , stepY_(surface.sizeY() / (rows_ - 1)) {
    heights_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            heights_.push_back(surface.at(x(column), y(row)).height);
        }
    }
}

double BruteClosestPoints::squaredAt(const Vector3& query, int row, int column) const {
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                              static_cast<std::size_t>(column);
    return (Vector3(x(column), y(row), heights_[index]) - query).squaredNorm();
}

bool BruteClosestPoints::isLowest(const Vector3& query, const Position& position) const {
    for (int row = std::max(position.row - 1, 0); row <= std::min(position.row + 1, rows_ - 1);
         ++row) {
        for (int column = std::max(position.column - 1, 0);
             column <= std::min(position.column + 1, columns_ - 1); ++column) {
            if (squaredAt(query, row, column) < position.squared) {
                return false;
            }
        }
    }
    return true;
}

std::vector<BruteClosestPoints::Position>
BruteClosestPoints::lowestPositions(const Vector3& query) const {
    std::vector<Position> lowest;
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            const Position position{
                .squared = squaredAt(query, row, column), .row = row, .column = column};
            if (isLowest(query, position)) {
                lowest.push_back(position);
            }
        }
    }
    std::ranges::sort(lowest, {}, &Position::squared);
    lowest.resize(std::min(lowest.size(), kMaxStarts));
    return lowest;
}

std::vector<ClosestPoint> BruteClosestPoints::near(const Vector3& query) const {
    std::vector<ClosestPoint> points;
    for (const Position& position : lowestPositions(query)) {
        points.push_back(
            localClosestPoint(surface_, query, {x(position.column), y(position.row), true}));
    }
    std::ranges::sort(points, {},
                      [](const ClosestPoint& closest) { return std::abs(closest.distance); });
    return points;
}

}  // namespace asperity::test
