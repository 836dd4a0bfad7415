#include "core/surface/Levelling.h"

#include "core/Error.h"
#include "core/Vector.h"

#include <Eigen/QR>

#include <algorithm>
#include <vector>

namespace asperity {

namespace {

bool counts(const HeightMap& map, int row, int column) {
    return map.isValid(row, column) && isFiniteHeight(map.at(row, column));
}

/// Mean of value(row, column) over the valid pixels: row by row, then once more over what is left,
/// so that rounding does not grow with the number of pixels.
template <class Value>
double meanOverValid(const HeightMap& map, const Value& value) {
    double mean = 0.0;
    for (int pass = 0; pass < 2; ++pass) {
        double sum = 0.0;
        double count = 0.0;
        for (int row = 0; row < map.rows; ++row) {
            double rowSum = 0.0;
            for (int column = 0; column < map.columns; ++column) {
                if (!counts(map, row, column)) {
                    continue;
                }
                rowSum += value(row, column) - mean;
                count += 1.0;
            }
            sum += rowSum;
        }
        if (count == 0.0) {
            throw Error("the height map holds no valid pixel");
        }
        mean += sum / count;
    }
    return mean;
}

double heightMean(const HeightMap& map) {
    return meanOverValid(map, [&](int row, int column) { return map.at(row, column); });
}

template <class Removed>
void subtract(HeightMap& map, const Removed& removed) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            map.heights[map.index(row, column)] -= removed(row, column);
        }
    }
}

double xOf(const HeightMap& map, int column) { return (column + 0.5) * map.pitchX; }
double yOf(const HeightMap& map, int row) { return (map.rows - row - 0.5) * map.pitchY; }

void removePlane(HeightMap& map) {
    const PlaneFit plane = fitPlane(map);
    subtract(map, [&](int row, int column) { return plane.at(xOf(map, column), yOf(map, row)); });
}

/// The mean of the two middle values when their number is even, as in statistics.
double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) {
        return *middle;
    }
    return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

void removeRowMedians(HeightMap& map) {
    std::vector<double> medians(static_cast<std::size_t>(map.rows), 0.0);
    std::vector<double> values;
    for (int row = 0; row < map.rows; ++row) {
        values.clear();
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                values.push_back(map.at(row, column));
            }
        }
        if (!values.empty()) {
            medians[static_cast<std::size_t>(row)] = median(values);
        }
    }
    subtract(map, [&](int row, int) { return medians[static_cast<std::size_t>(row)]; });
    const double mean = heightMean(map);
    subtract(map, [mean](int, int) { return mean; });
}

}  // namespace

PlaneFit fitPlane(const HeightMap& map) {
    requireUsable(map);
    const double centreColumn = meanOverValid(map, [](int, int column) { return column; });
    const double centreRow = meanOverValid(map, [](int row, int) { return row; });
    const double mean = heightMean(map);
    Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (!counts(map, row, column)) {
                continue;
            }
            const Eigen::Vector2d arm(column - centreColumn, centreRow - row);
            moments += arm * arm.transpose();
            tilt += arm * (map.at(row, column) - mean);
        }
    }
    // The smallest solution: level across a line, should the pixels form one.
    const Eigen::Vector2d perPixel =
        Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix2d>(moments).solve(tilt);
    return {.slopeX = perPixel.x() / map.pitchX,
            .slopeY = perPixel.y() / map.pitchY,
            .mean = mean,
            .centreX = (centreColumn + 0.5) * map.pitchX,
            .centreY = (map.rows - centreRow - 0.5) * map.pitchY};
}

HeightMap levelled(HeightMap map, Levelling levelling) {
    requireUsable(map);
    switch (levelling) {
    case Levelling::None:
        break;
    case Levelling::Plane:
        removePlane(map);
        break;
    case Levelling::Rows:
        removeRowMedians(map);
        break;
    }
    return map;
}

}  // namespace asperity
