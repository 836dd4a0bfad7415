#include "core/map/MeasuredMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kMostMisfit = 0.02;  // of a side

/// Two neighboring pixels, and the weight of the second.
struct Neighbors {
    int first = 0;
    int second = 0;
    double part = 0.0;
};

/// @param place along a side, 0 at its beginning, 1 at its end @param pixels of the side
Neighbors neighborsAt(double place, int pixels) {
    constexpr double kSame = 1e-6;  // rounding of places must mix no pixels
    double center = std::clamp(place * pixels - 0.5, 0.0, pixels - 1.0);
    if (std::abs(center - std::round(center)) < kSame) {
        center = std::round(center);
    }
    const int first = static_cast<int>(center);
    return {.first = first,
            .second = std::min(first + 1, pixels - 1),
            .part = center - static_cast<double>(first)};
}

double valueOf(const HeightMap& map, int row, int column) {
    return map.isValid(row, column) ? map.at(row, column)
                                    : std::numeric_limits<double>::quiet_NaN();
}

/// A neighbor without weight may hold no data. Not std::lerp(): it may return the other one.
double mixed(double first, double second, double part) {
    return part > 0.0 ? first + part * (second - first) : first;
}

double valueAt(const HeightMap& map, const Neighbors& rows, const Neighbors& columns) {
    std::array<double, 2> mixedRows{};
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const int row = i == 0 ? rows.first : rows.second;
        mixedRows.at(i) = mixed(valueOf(map, row, columns.first), valueOf(map, row, columns.second),
                                columns.part);
    }
    return mixed(mixedRows[0], mixedRows[1], rows.part);
}

}  // namespace

std::optional<MapRegion> measuredArea(double width, double height, const MapPlan& plan,
                                      const MapRegion& scan) {
    std::optional<MapRegion> nearest;
    double least = kMostMisfit;
    for (const MapRegion& area : {plan.region, scan}) {
        const double misfit = std::max(std::abs(width / (area.right - area.left) - 1.0),
                                       std::abs(height / (area.top - area.bottom) - 1.0));
        if (misfit <= least && !(nearest && misfit == least)) {
            nearest = area;
            least = misfit;
        }
    }
    return nearest;
}

std::vector<double> valuesAt(const MapPlan& plan, const HeightMap& measured,
                             const MapRegion& area) {
    std::vector<Neighbors> columns;
    for (int column = 0; column < plan.grid.columns; ++column) {
        columns.push_back(neighborsAt(
            (plan.place(0, column).x() - area.left) / (area.right - area.left), measured.columns));
    }
    std::vector<double> values;
    for (int row = 0; row < plan.grid.rows; ++row) {
        const Neighbors rows = neighborsAt(
            (area.top - plan.place(row, 0).y()) / (area.top - area.bottom), measured.rows);
        for (const Neighbors& neighbors : columns) {
            values.push_back(valueAt(measured, rows, neighbors));
        }
    }
    return values;
}

}  // namespace asperity
