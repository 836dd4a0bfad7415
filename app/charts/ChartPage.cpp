#include "app/charts/ChartPage.h"

#include "app/charts/ChartPen.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity {

namespace {

// Sizes in pixels of 1/96 inch, on a page whose letters have their usual size.
constexpr double kUsualWidth = 400.0;  // of a chart
constexpr double kUsualHeight = 260.0;
constexpr double kMinScale = 0.5;  // of letters: 6 of 12 pixels
constexpr double kMaxScale = 1.5;
constexpr double kWideChart = 1.5;  // width over height that a chart has best

constexpr double kTitle = 15.0;      // sizes of fonts
constexpr double kTitleShare = 0.8;  // of a chart's width, at most
constexpr double kName = 13.0;
constexpr double kTick = 12.0;
constexpr double kEdge = 10.0;
constexpr double kTickLength = 5.0;
constexpr double kTickWidth = 55.0;  // between ticks, at least
constexpr double kTickHeight = 32.0;
constexpr double kMinNameSize = 0.85;     // of columns, before some are left out
constexpr double kMinCategorySize = 0.6;  // of categories, where no name is left out
constexpr double kRowNames = 0.35;        // of a chart's width, for names of rows at most

using Point = ChartPage::Point;
using Anchor = ChartPage::Anchor;

/// The part of a curve that lies in a range, cut at its borders.
Curve cut(const Curve& curve, const ChartRange& range) {
    Curve part = curve;
    part.x.clear();
    part.y.clear();
    const auto add = [&part](double x, double y) {
        part.x.push_back(x);
        part.y.push_back(y);
    };
    const auto isIn = [&range](double x) { return x >= range.low && x <= range.high; };
    if (curve.points || curve.rings) {
        for (std::size_t i = 0; i < curve.x.size(); ++i) {  // labels keep their positions
            add(curve.x[i], isIn(curve.x[i]) ? curve.y[i] : std::nan(""));
        }
        return part;
    }
    bool goesOn = false;  // from what was added last
    for (std::size_t i = 1; i < curve.x.size(); ++i) {
        const double from = curve.x[i - 1];
        const double to = curve.x[i];
        if (!std::isfinite(from + to + curve.y[i - 1] + curve.y[i])) {
            goesOn = false;
            continue;
        }
        double begin = 0.0;  // of the distance from one sample to the next
        double end = isIn(from) ? 1.0 : 0.0;
        if (from != to) {
            const double low = (range.low - from) / (to - from);
            const double high = (range.high - from) / (to - from);
            begin = std::max(0.0, std::min(low, high));
            end = std::min(1.0, std::max(low, high));
        }
        if (begin >= end) {
            goesOn = false;
            continue;
        }
        const auto x = [&](double share) { return std::lerp(from, to, share); };
        const auto y = [&](double share) { return std::lerp(curve.y[i - 1], curve.y[i], share); };
        if (!goesOn) {
            add(std::nan(""), std::nan(""));
            add(x(begin), y(begin));
        }
        add(x(end), y(end));
        goesOn = end == 1.0;
    }
    return part;
}

/// With curves that lie in its range.
Chart shownPart(Chart chart) {
    for (Curve& curve : chart.curves) {
        if (curve.x.size() != curve.y.size() ||
            (!curve.pointLabels.empty() && curve.pointLabels.size() != curve.x.size())) {
            throw Error("The chart \"" + chart.title +
                        "\" cannot be drawn: the arrays of its curve \"" + curve.label +
                        "\" differ in length.");
        }
        if (chart.xRange) {
            curve = cut(curve, *chart.xRange);
        }
    }
    return chart;
}

std::vector<double> allX(const Chart& chart) {
    std::vector<double> all;
    for (const Curve& curve : chart.curves) {
        all.insert(all.end(), curve.x.begin(), curve.x.end());
    }
    return all;
}

std::vector<double> allY(const Chart& chart) {
    std::vector<double> all = chart.yHolds;
    for (const Curve& curve : chart.curves) {
        all.insert(all.end(), curve.y.begin(), curve.y.end());
    }
    return all;
}

/// One chart on the page.
class ChartLayout {
public:
    ChartLayout(ChartPen& pen, const Chart& chart, const Area& area, const TitleLook& titles,
                const PictureParts& parts)
        : pen_(pen)
        , chart_(chart)
        , area_(area)
        , titles_(titles)
        , parts_(parts)
        , x_({chart.xLabel, chart.xUnit, chart.logX, ticksIn(area.width, kTickWidth), chart.xNames,
              chart.xRange},
             allX(chart))
        , y_({chart.yLabel, chart.yUnit, chart.logY, ticksIn(area.height, kTickHeight),
              chart.yNames},
             allY(chart)) {}

    void draw() {
        placePlot();
        for (const ChartBox& box : chart_.boxes) {
            const Point corner = position(x_.position(box.left), y_.position(box.high));
            const Point end = position(x_.position(box.right), y_.position(box.low));
            pen_.box({corner.x, corner.y, end.x - corner.x, end.y - corner.y}, box.color);
        }
        drawFrame();
        for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
            drawCurve(chart_.curves[i], colorOf(i));
        }
        if (parts_.labels) {
            pen_.title({plot_.left, area_.top + pen_.scaled(kEdge)}, chart_.title, titles_.size,
                       kTitleShare * area_.width);
            pen_.legend({plot_.left, plot_.top - pen_.legendHeight(legend(), legendWidth())},
                        legend(), legendWidth());
            drawPointLabels();
        }
        if (parts_.bars) {
            drawNumbers();
        }
    }

private:
    [[nodiscard]] int ticksIn(double length, double distance) const {
        return std::max(2, static_cast<int>(0.8 * length / pen_.scaled(distance)));
    }

    void placePlot() {
        double left = pen_.scaled(kEdge);
        double below = pen_.scaled(kEdge);
        if (parts_.bars) {
            const double widest = widestOf(y_.labels(), pen_.scaled(kTick));
            ySize_ = std::min(1.0, kRowNames * area_.width / widest) * kTick;
            left += widest * ySize_ / kTick + pen_.scaled(2.0 * kTickLength + kLineHeight * kName);
            below += pen_.scaled(kTickLength + kLineHeight * (kTick + kName));
        }
        double above = pen_.scaled(kEdge);
        if (parts_.labels) {
            above += kLineHeight * titles_.size * static_cast<double>(titles_.lines) +
                     pen_.legendHeight(legend(), legendWidth());
        }
        plot_ = {area_.left + left, area_.top + above,
                 area_.width - left - 2.0 * pen_.scaled(kEdge), area_.height - above - below};
    }

    /// @param x, y in the axes' own numbers
    [[nodiscard]] Point position(double x, double y) const {
        return {plot_.left + (x - x_.low()) / (x_.high() - x_.low()) * plot_.width,
                plot_.bottom() - (y - y_.low()) / (y_.high() - y_.low()) * plot_.height};
    }

    void drawFrame() {
        const auto grid = [this](const ChartAxis& axis, double tick, const Point& from,
                                 const Point& to) {
            pen_.line({from, to}, axis.isZeroLine(tick) ? kLightPalette.muted : kLightPalette.faint,
                      0.8);
        };
        if (parts_.grid && chart_.boxes.empty()) {
            for (const double tick : x_.ticks()) {
                grid(x_, tick, position(tick, y_.low()), position(tick, y_.high()));
            }
            for (const double tick : y_.ticks()) {
                grid(y_, tick, position(x_.low(), tick), position(x_.high(), tick));
            }
        }
        if (parts_.bars) {
            pen_.line({position(x_.low(), y_.high()), position(x_.low(), y_.low()),
                       position(x_.high(), y_.low())},
                      kLightPalette.muted, 1.0);
        }
    }

    void drawCurve(const Curve& curve, const Color& color) {
        for (const std::vector<Point>& piece : pieces(curve)) {
            if (curve.points || curve.rings) {
                for (const Point& point : piece) {
                    pen_.dot(point, curve, color);
                }
            } else {
                pen_.line(piece, color, curve.width, curve.dashed);
            }
        }
    }

    /// Its positions, thinned; a sample without one parts two pieces.
    [[nodiscard]] std::vector<std::vector<Point>> pieces(const Curve& curve) const {
        constexpr std::size_t kBuckets = 2000;
        std::vector<std::vector<Point>> all;
        Series series;
        const auto finish = [&] {
            if (series.x.empty()) {
                return;
            }
            const Series thin =
                curve.points || curve.rings ? series : decimateMinMax(series, kBuckets);
            std::vector<Point> piece;
            for (std::size_t i = 0; i < thin.x.size(); ++i) {
                piece.push_back(position(thin.x[i], thin.y[i]));
            }
            all.push_back(std::move(piece));
            series = {};
        };
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const double x = x_.position(curve.x[i]);
            const double y = y_.position(curve.y[i]);
            if (std::isfinite(x) && std::isfinite(y)) {
                series.x.push_back(x);
                series.y.push_back(y);
            } else {
                finish();
            }
        }
        finish();
        return all;
    }

    [[nodiscard]] Color colorOf(std::size_t curve) const {
        return chart_.curves[curve].color.value_or(seriesColor(kLightPalette, curve));
    }

    [[nodiscard]] std::vector<ChartLegendEntry> legend() const {
        std::vector<ChartLegendEntry> entries;
        for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
            if (!chart_.curves[i].label.empty()) {
                entries.push_back({chart_.curves[i].label, colorOf(i), &chart_.curves[i]});
            }
        }
        return entries;
    }
    [[nodiscard]] double legendWidth() const { return area_.width - pen_.scaled(6.0 * kEdge); }

    void drawPointLabels() {
        if (std::ranges::all_of(chart_.curves,
                                [](const Curve& curve) { return curve.pointLabels.empty(); })) {
            return;
        }
        LabelPlacer placer(plot_);
        for (const Curve& curve : chart_.curves) {
            for (const std::vector<Point>& piece : pieces(curve)) {
                for (std::size_t i = 0; i < piece.size(); ++i) {
                    if (curve.points || curve.rings) {
                        placer.blockDot(piece[i], pen_.scaled(curve.dotSize));
                    } else if (i > 0) {
                        placer.blockLine(piece[i - 1], piece[i]);
                    }
                }
            }
        }
        for (const Curve& curve : chart_.curves) {
            for (std::size_t i = 0; i < curve.pointLabels.size(); ++i) {
                const Point dot = position(x_.position(curve.x[i]), y_.position(curve.y[i]));
                if (std::isfinite(dot.x) && std::isfinite(dot.y)) {
                    const std::string& label = curve.pointLabels[i];
                    const double size = pen_.scaled(kTick);
                    const Area found = placer.place(dot, pen_.scaled(curve.dotSize),
                                                    estimatedWidth(label, size), 1.2 * size);
                    pen_.text({found.left, found.top + 0.5 * found.height}, label, kTick);
                }
            }
        }
    }

    /// Returns the size of the letters of an axis' name: about as long as the axis at most.
    [[nodiscard]] double nameSize(const std::string& name, double length) const {
        constexpr double kMax = 1.15;
        const double width = estimatedWidth(name, pen_.scaled(kName));
        return width > 0.0 ? kName * std::min(1.0, kMax * length / width) : kName;
    }

    void drawNumbers() {
        drawColumnNumbers();
        const auto stride = static_cast<std::size_t>(
            std::ceil(kLineHeight * pen_.scaled(ySize_) *
                      static_cast<double>(chart_.yNames.size()) / plot_.height));
        for (std::size_t i = 0; i < y_.ticks().size(); ++i) {
            const Point at = position(x_.low(), y_.ticks()[i]);
            pen_.line({{at.x - pen_.scaled(kTickLength), at.y}, at}, kLightPalette.muted, 1.0);
            if (i % std::max<std::size_t>(1, stride) == 0) {
                pen_.text({at.x - pen_.scaled(1.6 * kTickLength), at.y}, y_.labels()[i], ySize_,
                          Anchor::End);
            }
        }
        pen_.text({plot_.left + 0.5 * plot_.width,
                   plot_.bottom() + pen_.scaled(kTickLength + kLineHeight * kTick + 0.6 * kName)},
                  x_.title(), nameSize(x_.title(), plot_.width), Anchor::Middle);
        pen_.text({area_.left + pen_.scaled(0.5 * kEdge + 0.5 * kName),
                   plot_.top + 0.5 * plot_.height},
                  y_.title(), nameSize(y_.title(), plot_.height), Anchor::Middle)
            .upright = true;
    }

    /// Names of categories shrink, then some are left out.
    void drawColumnNumbers() {
        double size = kTick;
        std::size_t stride = 1;
        if (!chart_.xNames.empty()) {
            const double room = plot_.width / static_cast<double>(chart_.xNames.size());
            const double widest =
                widestOf(chart_.xNames, pen_.scaled(kTick)) + pen_.scaled(0.5 * kTick);
            const double shrunk = std::clamp(
                room / widest, chart_.boxes.empty() ? kMinCategorySize : kMinNameSize, 1.0);
            size *= shrunk;
            stride = static_cast<std::size_t>(std::ceil(widest * shrunk / room - 1e-9));
        }
        for (std::size_t i = 0; i < x_.ticks().size(); ++i) {
            const Point at = position(x_.ticks()[i], y_.low());
            pen_.line({at, {at.x, at.y + pen_.scaled(kTickLength)}}, kLightPalette.muted, 1.0);
            if (i % stride == 0) {
                pen_.text({at.x, at.y + pen_.scaled(kTickLength + 0.75 * kTick)}, x_.labels()[i],
                          size, Anchor::Middle);
            }
        }
    }

    ChartPen& pen_;
    const Chart& chart_;
    Area area_;
    TitleLook titles_;
    PictureParts parts_;
    ChartAxis x_;
    ChartAxis y_;
    Area plot_;
    double ySize_ = kTick;  ///< of the font of the y axis' numbers
};

std::size_t columnsFor(std::size_t charts, double width, double height) {
    std::size_t best = 1;
    double largest = 0.0;
    for (std::size_t columns = 1; columns <= charts; ++columns) {
        const std::size_t rows = (charts + columns - 1) / columns;
        const double size = std::min(width / static_cast<double>(columns) / kWideChart,
                                     height / static_cast<double>(rows));
        if (size > largest) {
            largest = size;
            best = columns;
        }
    }
    return best;
}

/// Letters shrink less than a small chart does.
double letterScale(double width, double height) {
    constexpr double kShrink = 0.6;
    const double size = std::min(width / kUsualWidth, height / kUsualHeight);
    return size < 1.0 ? std::pow(size, kShrink) : std::min(size, kMaxScale);
}

/// Title and keys of a page. @return their height
double drawHead(ChartPen& pen, const ChartSheet& sheet) {
    const double edge = pen.scaled(kEdge);
    const double width = sheet.width - 2.0 * edge;
    double y = 0.0;
    if (!sheet.title.empty()) {
        const TitleLook look = titleLook({sheet.title}, width, pen.scaled(kTitle));
        pen.title({edge, edge}, sheet.title, look.size, width);
        y = edge + kLineHeight * look.size * static_cast<double>(look.lines);
    }
    std::vector<ChartLegendEntry> entries;
    for (const ChartKey& key : sheet.keys) {
        entries.push_back({key.text, key.color});
    }
    if (!entries.empty()) {
        pen.legend({edge, y}, entries, width);
        y += pen.legendHeight(entries, width);
    }
    return y;
}

}  // namespace

void addShares(Chart& chart, std::size_t column, std::size_t row, std::span<const double> shares,
               std::span<const ChartKey> keys) {
    constexpr double kHalf = 0.49;  // of a cell: there is a gap to the next one
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    const auto x = static_cast<double>(column);
    double low = static_cast<double>(row) - kHalf;
    for (std::size_t i = 0; total > 0.0 && i < std::min(shares.size(), keys.size()); ++i) {
        const double high = low + 2.0 * kHalf * shares[i] / total;
        if (high > low) {
            chart.boxes.push_back({x - kHalf, x + kHalf, low, high, keys[i].color});
        }
        low = high;
    }
}

ChartPage layOut(std::span<const Chart> charts, const ChartSheet& sheet) {
    ChartPage page{.width = sheet.width, .height = sheet.height, .parts = {}};
    const std::size_t columns =
        sheet.columns > 0 ? sheet.columns : columnsFor(charts.size(), page.width, page.height);
    const std::size_t rows = std::max<std::size_t>(1, (charts.size() + columns - 1) / columns);
    const double width = page.width / static_cast<double>(columns);
    const double height = page.height / static_cast<double>(rows);
    const double scale = sheet.letters > 0.0 ? sheet.letters : letterScale(width, height);
    if (scale < kMinScale) {
        throw Error(
            formatted("a page of %.0f x %.0f mm is too small for charts (%zu) whose letters "
                      "can be read: give more pixels (--size) or fewer per inch (--dpi)",
                      page.width / 96.0 * 25.4, page.height / 96.0 * 25.4, charts.size()));
    }
    ChartPen pen(page, scale);
    const double top = sheet.parts.labels ? drawHead(pen, sheet) : 0.0;
    const double rest = (page.height - top) / static_cast<double>(rows);
    std::vector<std::string> titles;
    for (const Chart& chart : charts) {
        titles.push_back(chart.title);
    }
    const TitleLook look = titleLook(titles, kTitleShare * width, scale * kTitle);
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const Area area{static_cast<double>(i % columns) * width,
                        top + static_cast<double>(i / columns) * rest, width, rest};
        const Chart shown = shownPart(charts[i]);
        ChartLayout(pen, shown, area, look, sheet.parts).draw();
    }
    return page;
}

}  // namespace asperity
