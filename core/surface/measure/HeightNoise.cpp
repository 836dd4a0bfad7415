#include "core/surface/measure/HeightNoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr int kWidth = 5;
constexpr std::array<double, kWidth> kDifference{1.0, -4.0, 6.0, -4.0, 1.0};
constexpr double kSquares = 70.0;  // sum of their squares

/// Fourth difference along both axes from a pixel on, in standard deviations of a height [m]; NaN
/// where a height is missing.
template <class Map>
double differenceAt(const Map& map, int row, int column) {
    double sum = 0.0;
    for (int i = 0; i < kWidth; ++i) {
        for (int j = 0; j < kWidth; ++j) {
            const double height = map.isValid(row + i, column + j)
                                      ? map.at(row + i, column + j)
                                      : std::numeric_limits<double>::quiet_NaN();
            sum += kDifference[static_cast<std::size_t>(i)] *
                   kDifference[static_cast<std::size_t>(j)] * height;
        }
    }
    return sum / kSquares;
}

template <class Map>
double noiseOf(const Map& map) {
    constexpr double kMedian = 0.67448975019608171;  // of a normal variable's magnitude
    constexpr double kPlaces = 65536.0;
    const int rows = map.rows - kWidth + 1;
    const int columns = map.columns - kWidth + 1;
    if (rows < 1 || columns < 1) {
        return 0.0;
    }
    const double share = static_cast<double>(rows) * columns / kPlaces;
    const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
    std::vector<double> found;
    for (int row = 0; row < rows; row += step) {
        for (int column = 0; column < columns; column += step) {
            const double difference = differenceAt(map, row, column);
            if (isFiniteHeight(difference)) {
                found.push_back(std::abs(difference));
            }
        }
    }
    if (found.empty()) {
        return 0.0;
    }
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::ranges::nth_element(found, middle);
    return *middle / kMedian;
}

}  // namespace

double heightNoise(const HeightMap& map) { return noiseOf(map); }

double heightNoise(const ScanMap& map) { return noiseOf(map); }

}  // namespace asperity
