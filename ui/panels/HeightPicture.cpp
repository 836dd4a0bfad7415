#include "ui/panels/HeightPicture.h"

#include "ui/Theme.h"
#include "ui/panels/ReliefImage.h"
#include "vtkplugins/pictures/ColorMaps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr int kMaxPictureSide = 512;  // [pixel]
constexpr double kOutliers = 0.005;   // share of the pixels at either end

/// Pixels of the picture, each with one of the map; NaN where that holds no data.
struct Sampled {
    int columns = 0;
    int rows = 0;
    std::vector<double> heights;
};

Sampled sampled(const HeightMap& map) {
    const int longer = std::max(map.columns, map.rows);
    const auto pixels = [longer](int count) {
        return longer <= kMaxPictureSide
                   ? count
                   : std::max(1, static_cast<int>(std::lround(static_cast<double>(count) *
                                                              kMaxPictureSide / longer)));
    };
    Sampled picture{.columns = pixels(map.columns), .rows = pixels(map.rows), .heights = {}};
    picture.heights.reserve(static_cast<std::size_t>(picture.columns) *
                            static_cast<std::size_t>(picture.rows));
    for (int row = 0; row < picture.rows; ++row) {
        const auto from = static_cast<int>((row + 0.5) * map.rows / picture.rows);
        for (int column = 0; column < picture.columns; ++column) {
            const auto at = static_cast<int>((column + 0.5) * map.columns / picture.columns);
            picture.heights.push_back(map.isValid(from, at) ? map.at(from, at) : std::nan(""));
        }
    }
    return picture;
}

/// @param heights of which some are numbers; their order is lost
ColorTable robustColors(std::vector<double> heights) {
    const auto skip = static_cast<std::ptrdiff_t>(kOutliers * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), heights.begin() + skip, heights.end());
    const double low = heights[static_cast<std::size_t>(skip)];
    const auto last = static_cast<std::ptrdiff_t>(heights.size()) - 1 - skip;
    std::nth_element(heights.begin(), heights.begin() + last, heights.end());
    return {ColorMap::Standard, low, heights[static_cast<std::size_t>(last)]};
}

}  // namespace

QImage heightPicture(const HeightMap& map) {
    const Sampled picture = sampled(map);
    std::vector<double> known;
    std::ranges::copy_if(picture.heights, std::back_inserter(known),
                         [](double height) { return isFiniteHeight(height); });
    const ColorTable colors =
        known.empty() ? ColorTable(ColorMap::Standard, 0.0, 0.0) : robustColors(std::move(known));
    QImage image(picture.columns, picture.rows, QImage::Format_RGB32);
    std::size_t next = 0;
    for (int row = 0; row < picture.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < picture.columns; ++column, ++next) {
            const double height = picture.heights[next];
            const QColor color =
                isFiniteHeight(height) ? toQColor(colors.of(height)) : hatched(row, column);
            line[column] = color.rgb();
        }
    }
    return image;
}

}  // namespace asperity
