#include "app/exports/PlotPage.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "vtkplugins/pictures/ChartAxis.h"
#include "vtkplugins/pictures/Decimation.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

// Of a page whose letters have their usual size.
constexpr double kUsualWidth = 400.0;  // of a chart
constexpr double kUsualHeight = 260.0;
constexpr double kMinScale = 0.5;  // of letters: 6 of 12 pixels
constexpr double kMaxScale = 1.5;
constexpr double kWideChart = 1.5;  // width over height that a chart has best

constexpr double kTitle = 15.0;      // sizes of fonts
constexpr double kTitleShare = 0.8;  // of a chart's width, at most
constexpr double kName = 13.0;
constexpr double kTick = 12.0;
constexpr double kLegend = 12.0;
constexpr double kEdge = 10.0;
constexpr double kLine = 1.4;  // of letters, from one line to the next
constexpr double kTickLength = 5.0;
constexpr double kTickWidth = 55.0;  // between ticks, at least
constexpr double kTickHeight = 32.0;
constexpr double kSwatch = 20.0;
constexpr double kCurve = 1.6;
constexpr double kDotRadius = 3.5;
constexpr double kLetter = 0.58;  // width of a letter on average, of the font's size

/// Wide enough for most texts, with any font.
double estimatedWidth(const std::string& text, double size) {
    const auto letters = std::ranges::count_if(
        text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; });
    return kLetter * size * static_cast<double>(letters);
}

std::vector<double> allValues(const Chart& chart, std::vector<double> Curve::*values) {
    std::vector<double> all;
    for (const Curve& curve : chart.curves) {
        all.insert(all.end(), (curve.*values).begin(), (curve.*values).end());
    }
    return all;
}

std::vector<double> allHeights(const Chart& chart) {
    std::vector<double> all = allValues(chart, &Curve::y);
    all.insert(all.end(), chart.yHolds.begin(), chart.yHolds.end());
    return all;
}

void check(const Chart& chart) {
    for (const Curve& curve : chart.curves) {
        if (curve.x.size() != curve.y.size()) {
            throw Error("The chart \"" + chart.title +
                        "\" cannot be drawn: the arrays of its curve \"" + curve.label +
                        "\" differ in length.");
        }
    }
}

/// A rectangle from its upper left corner.
struct Area {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// One chart on the page.
class ChartLayout {
public:
    /// @param titleSize of all titles of the page, so that they are alike
    ChartLayout(PlotPage& page, const Chart& chart, const Area& area, double scale,
                double titleSize, const PictureParts& parts)
        : page_(page)
        , chart_(chart)
        , area_(area)
        , scale_(scale)
        , titleSize_(titleSize)
        , parts_(parts)
        , x_({chart.xLabel, chart.xUnit, chart.logX, ticksIn(area.width, kTickWidth), chart.xNames},
             allValues(chart, &Curve::x))
        , y_({chart.yLabel, chart.yUnit, chart.logY, ticksIn(area.height, kTickHeight)},
             allHeights(chart)) {}

    void draw() {
        placePlot();
        drawFrame();
        drawCurves();
        if (parts_.labels) {
            drawTitle();
            drawLegend();
        }
        if (parts_.bars) {
            drawNumbers();
        }
    }

private:
    [[nodiscard]] int ticksIn(double length, double distance) const {
        return std::max(2, static_cast<int>(0.8 * length / (distance * scale_)));
    }

    void placePlot() {
        double left = scale_ * kEdge;
        double below = scale_ * kEdge;
        if (parts_.bars) {
            double widest = 0.0;
            for (const std::string& label : y_.labels()) {
                widest = std::max(widest, estimatedWidth(label, scale_ * kTick));
            }
            left += widest + scale_ * (2.0 * kTickLength + kLine * kName);
            below += scale_ * (kTickLength + kLine * (kTick + kName));
        }
        const double above =
            scale_ * kEdge + (parts_.labels ? scale_ * kLine * kTitle + legendHeight() : 0.0);
        plot_ = {area_.left + left, area_.top + above, area_.width - left - 2.0 * scale_ * kEdge,
                 area_.height - above - below};
    }

    [[nodiscard]] PlotPage::Point place(double x, double y) const {
        return {plot_.left + (x - x_.low()) / (x_.high() - x_.low()) * plot_.width,
                plot_.top + plot_.height - (y - y_.low()) / (y_.high() - y_.low()) * plot_.height};
    }

    void line(std::vector<PlotPage::Point> points, const Color& color, double width,
              bool dashed = false) {
        page_.lines.push_back({std::move(points), color, scale_ * width, dashed});
    }

    void drawFrame() {
        if (parts_.grid) {
            for (const double tick : x_.ticks()) {
                line({place(tick, y_.low()), place(tick, y_.high())}, kLightPalette.faint, 0.8);
            }
            for (const double tick : y_.ticks()) {
                line({place(x_.low(), tick), place(x_.high(), tick)}, kLightPalette.faint, 0.8);
            }
        }
        if (parts_.bars) {
            line(
                {place(x_.low(), y_.high()), place(x_.low(), y_.low()), place(x_.high(), y_.low())},
                kLightPalette.muted, 1.0);
        }
    }

    void drawCurves() {
        for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
            const Curve& curve = chart_.curves[i];
            for (const auto& piece : pieces(curve)) {
                if (curve.points) {
                    for (const PlotPage::Point& point : piece) {
                        page_.dots.push_back({point, scale_ * kDotRadius, colorOf(i)});
                    }
                } else {
                    line(piece, colorOf(i), kCurve, curve.dashed);
                }
            }
        }
    }

    /// Its places, thinned; a sample without a place parts two pieces.
    [[nodiscard]] std::vector<std::vector<PlotPage::Point>> pieces(const Curve& curve) const {
        constexpr std::size_t kBuckets = 2000;
        std::vector<std::vector<PlotPage::Point>> all;
        Series series;
        const auto finish = [&] {
            if (series.x.empty()) {
                return;
            }
            const Series thin = curve.points ? series : decimateMinMax(series, kBuckets);
            std::vector<PlotPage::Point> piece;
            for (std::size_t i = 0; i < thin.x.size(); ++i) {
                piece.push_back(place(thin.x[i], thin.y[i]));
            }
            all.push_back(std::move(piece));
            series = {};
        };
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const double x = x_.place(curve.x[i]);
            const double y = y_.place(curve.y[i]);
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

    PlotPage::Text& text(const PlotPage::Point& at, const std::string& text, double size,
                         Align align) {
        return page_.texts.emplace_back(PlotPage::Text{.at = at,
                                                       .text = text,
                                                       .size = scale_ * size,
                                                       .color = kLightPalette.ink,
                                                       .align = align});
    }

    void drawTitle() {
        text({plot_.left, area_.top + scale_ * (kEdge + 0.5 * kTitle)}, chart_.title, titleSize_,
             Align::Left)
            .bold = true;
    }

    /// Passes each entry's place, from the left, row by row. @return height of the rows
    template <class Put>
    // NOLINTNEXTLINE(modernize-use-nodiscard): it is called for either
    double layLegend(const Put& put) const {
        const double row = scale_ * kLine * kLegend;
        const double room = area_.width - scale_ * 6.0 * kEdge;
        double x = 0.0;
        double y = row;
        for (std::size_t i = 0; i < chart_.curves.size(); ++i) {
            const std::string& label = chart_.curves[i].label;
            if (label.empty()) {
                continue;
            }
            const double width =
                scale_ * (kSwatch + 1.5 * kEdge) + estimatedWidth(label, scale_ * kLegend);
            if (x > 0.0 && x + width > room) {
                x = 0.0;
                y += row;
            }
            put(i, PlotPage::Point{x, y - 0.5 * row});
            x += width;
        }
        return y + scale_ * 0.5 * kEdge;
    }

    [[nodiscard]] double legendHeight() const {
        return layLegend([](std::size_t, const PlotPage::Point&) {});
    }

    void drawLegend() {
        const double top = plot_.top - legendHeight();
        layLegend([&](std::size_t i, const PlotPage::Point& at) {
            const PlotPage::Point from{plot_.left + at.x, top + at.y};
            const PlotPage::Point to{from.x + scale_ * kSwatch, from.y};
            if (chart_.curves[i].points) {
                page_.dots.push_back(
                    {{0.5 * (from.x + to.x), from.y}, scale_ * kDotRadius, colorOf(i)});
            } else {
                line({from, to}, colorOf(i), 1.5 * kCurve, chart_.curves[i].dashed);
            }
            text({to.x + scale_ * 0.5 * kEdge, from.y}, chart_.curves[i].label, kLegend,
                 Align::Left);
        });
    }

    /// Of an axis, which its name does not exceed by much.
    [[nodiscard]] double nameSize(const std::string& name, double length) const {
        constexpr double kMost = 1.15;
        return kName * std::min(1.0, kMost * length / estimatedWidth(name, scale_ * kName));
    }

    void drawNumbers() {
        const double bottom = plot_.top + plot_.height;
        for (std::size_t i = 0; i < x_.ticks().size(); ++i) {
            const PlotPage::Point at = place(x_.ticks()[i], y_.low());
            line({at, {at.x, at.y + scale_ * kTickLength}}, kLightPalette.muted, 1.0);
            text({at.x, bottom + scale_ * (kTickLength + 0.75 * kTick)}, x_.labels()[i], kTick,
                 Align::Center);
        }
        for (std::size_t i = 0; i < y_.ticks().size(); ++i) {
            const PlotPage::Point at = place(x_.low(), y_.ticks()[i]);
            line({{at.x - scale_ * kTickLength, at.y}, at}, kLightPalette.muted, 1.0);
            text({at.x - scale_ * 1.6 * kTickLength, at.y}, y_.labels()[i], kTick, Align::Right);
        }
        text({plot_.left + 0.5 * plot_.width,
              bottom + scale_ * (kTickLength + kLine * kTick + 0.6 * kName)},
             x_.title(), nameSize(x_.title(), plot_.width), Align::Center);
        text({area_.left + scale_ * (0.5 * kEdge + 0.5 * kName), plot_.top + 0.5 * plot_.height},
             y_.title(), nameSize(y_.title(), plot_.height), Align::Center)
            .upright = true;
    }

    PlotPage& page_;
    const Chart& chart_;
    Area area_;
    double scale_;
    double titleSize_;
    PictureParts parts_;
    ChartAxis x_;
    ChartAxis y_;
    Area plot_;
};

/// Rows and columns of charts.
struct Grid {
    std::size_t columns = 1;
    std::size_t rows = 1;
};

Grid gridFor(std::size_t charts, double width, double height) {
    Grid best;
    double largest = 0.0;
    for (std::size_t columns = 1; columns <= charts; ++columns) {
        const std::size_t rows = (charts + columns - 1) / columns;
        const double size = std::min(width / static_cast<double>(columns) / kWideChart,
                                     height / static_cast<double>(rows));
        if (size > largest) {
            largest = size;
            best = {columns, rows};
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

}  // namespace

PlotPage plotPage(std::span<const Chart> charts, const PictureSpec& spec) {
    std::ranges::for_each(charts, check);
    PlotPage page{.width = spec.size.width / spec.pixelRatio(),
                  .height = spec.size.height / spec.pixelRatio(),
                  .lines = {},
                  .dots = {},
                  .texts = {}};
    const Grid grid = gridFor(charts.size(), page.width, page.height);
    const double width = page.width / static_cast<double>(grid.columns);
    const double height = page.height / static_cast<double>(grid.rows);
    const double scale = letterScale(width, height);
    if (scale < kMinScale) {
        throw Error(
            formatted("a page of %.0f x %.0f mm is too small for charts (%zu) whose letters "
                      "can be read: give more pixels (--size) or fewer per inch (--dpi)",
                      page.width / 96.0 * 25.4, page.height / 96.0 * 25.4, charts.size()));
    }
    double titleSize = kTitle;
    for (const Chart& chart : charts) {
        titleSize = std::min(titleSize, kTitleShare * width * kTitle /
                                            estimatedWidth(chart.title, scale * kTitle));
    }
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const std::size_t row = i / grid.columns;
        const std::size_t column = i % grid.columns;
        const Area area{static_cast<double>(column) * width, static_cast<double>(row) * height,
                        width, height};
        ChartLayout(page, charts[i], area, scale, titleSize, spec.parts).draw();
    }
    return page;
}

}  // namespace asperity
