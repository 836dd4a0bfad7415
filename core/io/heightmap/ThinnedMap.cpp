#include "core/io/heightmap/ThinnedMap.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr int kReports = 50;

int countOf(int pixels, int step) { return (pixels + step - 1) / step; }

int stepFor(const PixelRectangle& part, std::size_t most) {
    int step = 1;
    while (static_cast<std::size_t>(countOf(part.columns, step)) *
               static_cast<std::size_t>(countOf(part.rows, step)) >
           most) {
        ++step;
    }
    return step;
}

/// Returns the pixel that represents those of a step, in the middle of them.
int pixelOf(int index, int step, int pixels) {
    return std::min((index * step) + (step / 2), pixels - 1);
}

void markHoles(HeightMap& map) {
    const auto hasData = [](double height) { return isFiniteHeight(height); };
    if (std::ranges::all_of(map.heights, hasData)) {
        return;
    }
    map.invalid.resize(map.heights.size());
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (!hasData(map.heights[i])) {
            map.heights[i] = std::numeric_limits<double>::quiet_NaN();
            map.invalid[i] = true;
        }
    }
}

}  // namespace

ThinnedMap thinnedMap(const ScanFile& file, const ScanChannel& channel, const PixelRectangle& part,
                      Progress* progress, std::size_t most) {
    const int step = stepFor(part, most);
    const HeightRows rows = file.rowsOf(channel);
    ThinnedMap thinned{.map = {}, .step = step};
    HeightMap& map = thinned.map;
    map.columns = countOf(part.columns, step);
    map.rows = countOf(part.rows, step);
    map.pitchX = rows.pitchX * step;
    map.pitchY = rows.pitchY * step;
    map.heights.reserve(map.index(map.rows, 0));
    std::vector<double> values(static_cast<std::size_t>(rows.columns));
    for (int row = 0; row < map.rows; ++row) {
        if (row % (map.rows / kReports + 1) == 0) {
            reportTo(progress, static_cast<double>(row) / map.rows);
        }
        rows.readRow(part.row + pixelOf(row, step, part.rows), values.data());
        for (int column = 0; column < map.columns; ++column) {
            map.heights.push_back(values[static_cast<std::size_t>(
                part.column + pixelOf(column, step, part.columns))]);
        }
    }
    reportTo(progress, 1.0);
    markHoles(map);
    return thinned;
}

HeightStatistics heightStatistics(const HeightMap& map) {
    return heightStatistics([&map](const TakeRow& take) {
        std::vector<double> row(static_cast<std::size_t>(map.columns));
        for (int i = 0; i < map.rows; ++i) {
            for (int column = 0; column < map.columns; ++column) {
                row[static_cast<std::size_t>(column)] =
                    map.isValid(i, column) ? map.at(i, column)
                                           : std::numeric_limits<double>::quiet_NaN();
            }
            take(row);
        }
    });
}

}  // namespace asperity
