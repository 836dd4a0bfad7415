#include "vtkplugins/pictures/ShareMaps.h"

#include "core/Error.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity {

namespace {

constexpr double kMapsEdge = 20.0;
constexpr double kPageTitle = 30.0;
constexpr double kMapsTitle = 30.0;  // of a map
constexpr double kMapsLeft = 108.0;  // names of the rows and of the y axis
constexpr double kMapsBelow = 56.0;
constexpr double kMapsRight = 14.0;
constexpr double kGap = 1.0;         // between cells
constexpr double kNameWidth = 62.0;  // least distance of names
constexpr double kNameHeight = 20.0;
constexpr double kNameSize = 14.0;

void checkShareMap(const ShareMap& map) {
    if (map.columns.empty() || map.rows.empty() ||
        map.cells.size() != map.columns.size() * map.rows.size()) {
        throw Error("The map \"" + map.title +
                    "\" cannot be drawn: it needs one cell for each row and column.");
    }
}

void paintCell(Painter& painter, const PixelRect& area, const std::vector<double>& shares,
               const std::vector<ShareKey>& keys) {
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    double bottom = area.bottom;
    for (std::size_t i = 0; total > 0.0 && i < std::min(shares.size(), keys.size()); ++i) {
        const double height = area.height * shares[i] / total;
        painter.fill({area.left, bottom, area.width, height}, keys[i].color);
        bottom += height;
    }
}

/// One map in its place on the page.
class MapPainter {
public:
    MapPainter(const ShareMap& map, const PixelRect& area)
        : map_(map)
        , area_(area)
        , plot_{area.left + kMapsLeft, area.bottom + kMapsBelow,
                area.width - kMapsLeft - kMapsRight, area.height - kMapsTitle - kMapsBelow} {}

    void paint(Painter& painter, const std::vector<ShareKey>& keys) const {
        painter.paragraph({plot_.left, area_.top() - kMapsTitle, plot_.width, kMapsTitle - 6.0},
                          map_.title, {.size = 17.0, .bold = true});
        for (std::size_t i = 0; i < map_.cells.size(); ++i) {
            paintCell(painter, cell(i / map_.columns.size(), i % map_.columns.size()),
                      map_.cells[i], keys);
        }
        paintNames(painter);
    }

private:
    [[nodiscard]] PixelRect cell(std::size_t row, std::size_t column) const {
        const double width = plot_.width / static_cast<double>(map_.columns.size());
        const double height = plot_.height / static_cast<double>(map_.rows.size());
        return {plot_.left + static_cast<double>(column) * width,
                plot_.bottom + static_cast<double>(row) * height, width - kGap, height - kGap};
    }

    /// Of cells so wide, every how many one can be named.
    [[nodiscard]] static std::size_t stride(double cellSize, double nameSize) {
        return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(nameSize / cellSize)));
    }

    void paintNames(Painter& painter) const {
        const PixelRect first = cell(0, 0);
        for (std::size_t i = 0; i < map_.columns.size(); i += stride(first.width, kNameWidth)) {
            const PixelRect named = cell(0, i);
            painter.text({named.left + 0.5 * named.width, plot_.bottom - 14.0}, map_.columns[i],
                         {.size = kNameSize, .align = Align::Center});
        }
        for (std::size_t i = 0; i < map_.rows.size(); i += stride(first.height, kNameHeight)) {
            const PixelRect named = cell(i, 0);
            painter.text({plot_.left - 8.0, named.bottom + 0.5 * named.height}, map_.rows[i],
                         {.size = kNameSize, .align = Align::Right});
        }
        const TextStyle axis{.size = 15.0, .align = Align::Center};
        painter.text({plot_.left + 0.5 * plot_.width, plot_.bottom - 38.0}, map_.xLabel, axis);
        painter.upright({area_.left + 14.0, plot_.bottom + 0.5 * plot_.height}, map_.yLabel, axis);
    }

    const ShareMap& map_;
    PixelRect area_;
    PixelRect plot_;
};

std::vector<LegendEntry> legendOf(const ShareMapPage& page) {
    std::vector<LegendEntry> entries;
    for (const ShareKey& key : page.keys) {
        entries.push_back({key.color, key.text, LegendMark::Point});
    }
    return entries;
}

void paintPage(Painter& painter, const ShareMapPage& page, const PictureSize& size) {
    const double width = size.width - 2.0 * kMapsEdge;
    const std::vector<LegendEntry> legend = legendOf(page);
    const double legendHeight = legendHeightFor(legend, width);
    painter.paragraph({kMapsEdge, size.height - kMapsEdge - kPageTitle, width, kPageTitle - 4.0},
                      page.title, {.size = 20.0, .bold = true});
    const double top = size.height - kMapsEdge - kPageTitle - legendHeight;
    paintLegend(painter, legend, {kMapsEdge, top, width, legendHeight});
    const int count = static_cast<int>(page.maps.size());
    const int rows = (count + page.mapsPerRow - 1) / page.mapsPerRow;
    const double mapWidth = width / page.mapsPerRow;
    const double mapHeight = (top - 2.0 * kMapsEdge) / rows;
    for (int i = 0; i < count; ++i) {
        const PixelRect area{kMapsEdge + (i % page.mapsPerRow) * mapWidth,
                             top - kMapsEdge - (i / page.mapsPerRow + 1) * mapHeight, mapWidth,
                             mapHeight};
        MapPainter(page.maps[static_cast<std::size_t>(i)], area).paint(painter, page.keys);
    }
}

}  // namespace

void writeShareMaps(const std::filesystem::path& path, const ShareMapPage& page, PictureSize size) {
    if (page.maps.empty() || page.mapsPerRow < 1) {
        throw Error("A page of maps needs at least one map and one column.");
    }
    std::for_each(page.maps.begin(), page.maps.end(), checkShareMap);
    OffscreenPicture picture(size);
    picture.paint([&](Painter& painter) { paintPage(painter, page, size); });
    picture.writePng(path);
}

}  // namespace asperity
