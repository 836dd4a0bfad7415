#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <functional>
#include <vector>

namespace asperity {

/// A height map as those take it who need one row after the other: writers of files.
struct HeightRows {
    int columns = 0;
    int rows = 0;
    double pitchX = 0.0;  ///< pixel width [m]
    double pitchY = 0.0;  ///< pixel height [m]
    /// Writes the heights of a row, 0 at the top [m]; NaN where the scan holds no data.
    std::function<void(int row, double* heights)> readRow;
    /// The same with heights that were filled in where the scan holds none; empty: none were.
    std::function<void(int row, double* heights)> readFilledRow = {};

    [[nodiscard]] double sizeX() const { return columns * pitchX; }  ///< [m]
    [[nodiscard]] double sizeY() const { return rows * pitchY; }     ///< [m]
};

/// The rows of a map, which must outlive them. @throw Error when the map is unusable
[[nodiscard]] HeightRows rowsOf(const HeightMap& map);
[[nodiscard]] HeightRows rowsOf(const ScanMap& map);

/// Calls visit(row, heights), from the top down, with a std::vector<double>&.
/// @throw Canceled
template <class Visit>
void forEachRow(const HeightRows& rows, Progress* progress, const Visit& visit) {
    constexpr int kReports = 50;
    const int step = rows.rows / kReports + 1;
    std::vector<double> heights(static_cast<std::size_t>(rows.columns));
    for (int row = 0; row < rows.rows; ++row) {
        if (row % step == 0) {
            reportTo(progress, static_cast<double>(row) / rows.rows);
        }
        rows.readRow(row, heights.data());
        visit(row, heights);
    }
    reportTo(progress, 1.0);
}

}  // namespace asperity
