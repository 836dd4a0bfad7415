#include "vtkplugins/pictures/MapSheet.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

static_assert(kChartPixels == OffscreenPicture::kOversampling);

constexpr std::size_t kMaxMaps = 6;
constexpr int kMapsPerRow = 3;
constexpr int kWidth = 560;   // of a map with its bar [pixel]
constexpr int kHeight = 560;  // same
constexpr int kSheetTitle = 56;
constexpr double kSheetEdge = 20.0;
constexpr double kSheetBar = 52.0;

/// Never empty: a map of one value has it in the middle of a range that ticks can tell.
CentralRange colorsOf(const SheetMap& map) {
    constexpr double kOneValue = 1e-6;  // that the values differ by, relatively
    constexpr double kAround = 0.1;
    CentralRange range = map.range ? *map.range : centralRange(map.values);
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    if (range.high - range.low <= kOneValue * largest) {
        const double around = largest > 0.0 ? kAround * largest : 1.0;
        range = {range.low - around, range.high + around};
    }
    return range;
}

/// As far to either side of zero as the values go, to a number at which the bar has ticks.
CentralRange aroundZero(const CentralRange& range) {
    const double limit = std::max(std::abs(range.low), std::abs(range.high));
    const double decade = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double round : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0}) {
        if (limit <= round * decade) {
            return {-round * decade, round * decade};
        }
    }
    return {-10.0 * decade, 10.0 * decade};
}

/// A map in its area of the sheet.
class SheetPainter {
public:
    SheetPainter(const SheetMap& map, const PixelRect& area)
        : map_(map)
        , area_(area)
        , range_(map.isSigned ? aroundZero(colorsOf(map)) : colorsOf(map))
        , colors_(map.isSigned ? divergingTable(range_.high)
                               : heightTable(range_.low, range_.high)) {}

    void paint(Painter& painter) const {
        painter.image(area(), image());
        paintScaleBar(painter);
        drawColorBar(
            painter,
            {.quantity = map_.quantity,
             .unit = map_.unit,
             .low = range_.low,
             .high = range_.high,
             .table = colors_},
            {area_.left + kSheetEdge, area_.bottom, area_.width - 2.0 * kSheetEdge, kSheetBar});
    }

private:
    /// As large as its part of the sheet lets it be, in its own shape.
    [[nodiscard]] PixelRect area() const {
        const PixelRect room{area_.left + kSheetEdge, area_.bottom + kSheetBar + kSheetEdge,
                             area_.width - 2.0 * kSheetEdge,
                             area_.height - kSheetBar - 2.0 * kSheetEdge};
        const double aspect = map_.width / map_.height;
        const double width = std::min(room.width, room.height * aspect);
        const double height = width / aspect;
        return {room.left + 0.5 * (room.width - width), room.bottom + room.height - height, width,
                height};
    }

    /// On a plate in the lower left corner.
    void paintScaleBar(Painter& painter) const {
        constexpr double kShare = 0.3;  // of the width, at most
        constexpr double kMargin = 8.0;
        constexpr double kText = 24.0;  // height of its line
        const PixelRect map = area();
        const double length = niceBelow(kShare * map_.width);
        const double pixels = length / map_.width * map.width;
        const std::string text = formatSi(length, "m");
        const TextStyle style{.size = 15.0, .align = Align::Center};
        const double width = std::max(pixels, painter.textWidth(text, style)) + 2.0 * kMargin;
        const PixelRect plate{map.left + kMargin, map.bottom + kMargin, width, kText + kMargin};
        if (plate.right() > map.right() || plate.top() > map.top()) {  // a map of some lines
            return;
        }
        painter.fill(plate, kLightPalette.paper, 0.82);
        const double middle = plate.left + 0.5 * width;
        painter.text({middle, plate.top() - 0.5 * kText}, text, style);
        painter.fill({middle - 0.5 * pixels, plate.bottom + 5.0, pixels, 3.0}, kLightPalette.ink);
    }

    [[nodiscard]] RasterImage image() const {
        constexpr std::uint8_t kOpaque = 255;
        RasterImage image{.width = map_.columns, .height = map_.rows, .pixels = {}};
        for (const double value : map_.values) {
            const Color color = colorOf(value);
            image.pixels.insert(image.pixels.end(), {color.red, color.green, color.blue, kOpaque});
        }
        return image;
    }

    [[nodiscard]] Color colorOf(double value) const {
        constexpr Color kNoData{190, 190, 190};
        if (!std::isfinite(value)) {
            return kNoData;
        }
        const unsigned char* rgb = colors_->MapValue(value);
        return {rgb[0], rgb[1], rgb[2]};
    }

    const SheetMap& map_;
    PixelRect area_;
    CentralRange range_;
    vtkSmartPointer<vtkLookupTable> colors_;
};

void check(std::span<const SheetMap> maps) {
    if (maps.empty() || maps.size() > kMaxMaps) {
        throw Error("A sheet holds one to six maps.");
    }
    for (const SheetMap& map : maps) {
        const auto pixels =
            static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
        if (map.columns < 1 || map.rows < 1 || map.values.size() != pixels || !(map.width > 0.0) ||
            !(map.height > 0.0)) {
            throw Error("The map \"" + map.quantity +
                        "\" cannot be drawn: it needs one value for each pixel.");
        }
    }
}

/// Positions of maps and chart on a sheet.
class SheetLayout {
public:
    SheetLayout(std::size_t maps, bool hasChart)
        : maps_(static_cast<int>(maps))
        , columns_(hasChart ? kMapsPerRow : std::min(maps_, kMapsPerRow))
        , rows_((maps_ + (hasChart ? 1 : 0) + kMapsPerRow - 1) / kMapsPerRow) {}

    [[nodiscard]] PictureSize size() const {
        return {.width = kWidth * columns_, .height = kSheetTitle + kHeight * rows_};
    }
    [[nodiscard]] PixelRect map(int number) const {
        return {static_cast<double>(kWidth * (number % kMapsPerRow)),
                static_cast<double>(kHeight * (rows_ - 1 - number / kMapsPerRow)), kWidth, kHeight};
    }
    [[nodiscard]] PixelRect chart() const {
        PixelRect area = map(maps_);
        area.width = kWidth * columns_ - area.left - kSheetEdge;
        return area;
    }

private:
    int maps_;
    int columns_;
    int rows_;
};

}  // namespace

CentralRange centralRange(const std::vector<double>& values) {
    constexpr double kOuter = 0.01;
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double value) { return std::isfinite(value); });
    if (known.empty()) {
        return {};
    }
    std::ranges::sort(known);
    const auto last = static_cast<double>(known.size() - 1);
    return {known[static_cast<std::size_t>(std::floor(kOuter * last))],
            known[static_cast<std::size_t>(std::ceil((1.0 - kOuter) * last))]};
}

void writeMapSheet(const std::filesystem::path& path, const std::string& title,
                   std::span<const SheetMap> maps,
                   const std::function<RasterImage(const PictureSize&)>& chart) {
    check(maps);
    const SheetLayout layout(maps.size(), static_cast<bool>(chart));
    const PictureSize size = layout.size();
    OffscreenPicture picture(size);
    picture.paint([&](Painter& painter) {
        if (chart) {
            const PixelRect area = layout.chart();
            painter.image(area, chart({.width = static_cast<int>(area.width),
                                       .height = static_cast<int>(area.height)}));
        }
        painter.paragraph({kSheetEdge, size.height - kSheetTitle + 4.0,
                           size.width - 2.0 * kSheetEdge, kSheetTitle - 20.0},
                          title, {.size = 18.0, .bold = true});
        for (std::size_t i = 0; i < maps.size(); ++i) {
            SheetPainter(maps[i], layout.map(static_cast<int>(i))).paint(painter);
        }
    });
    picture.writePng(path);
}

}  // namespace asperity
