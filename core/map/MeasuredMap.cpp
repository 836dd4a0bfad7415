#include "core/map/MeasuredMap.h"

#include "core/surface/BetweenPixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kMostMisfit = 0.02;  // of a side

/// @param place along a side, 0 at its beginning, 1 at its end @param pixels of the side
BetweenPixels pixelsAt(double place, int pixels) {
    return betweenPixels(onCenter(place * pixels - 0.5), pixels);
}

double valueOf(const HeightMap& map, int row, int column) {
    return map.isValid(row, column) ? map.at(row, column)
                                    : std::numeric_limits<double>::quiet_NaN();
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
    std::vector<BetweenPixels> columns;
    for (int column = 0; column < plan.grid.columns; ++column) {
        columns.push_back(pixelsAt(
            (plan.place(0, column).x() - area.left) / (area.right - area.left), measured.columns));
    }
    const auto pixel = [&](int row, int column) { return valueOf(measured, row, column); };
    std::vector<double> values;
    for (int row = 0; row < plan.grid.rows; ++row) {
        const BetweenPixels rows =
            pixelsAt((area.top - plan.place(row, 0).y()) / (area.top - area.bottom), measured.rows);
        for (const BetweenPixels& around : columns) {
            values.push_back(bilinear(rows, around, pixel));
        }
    }
    return values;
}

}  // namespace asperity
