#include "app/reports/page/PlotDrawing.h"

#include "core/SiFormat.h"
#include "core/Utf8.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

constexpr double kWidth = 500.0;                           // [pt]
constexpr double kHeight = 290.0;                          // [pt], without legend
constexpr double kLeft = 54.0;                             // room for numbers and title [pt]
constexpr double kRight = 12.0;                            // [pt]
constexpr double kBottom = 40.0;                           // [pt]
constexpr double kTop = 8.0;                               // [pt]
constexpr double kTick = 4.0;                              // [pt]
constexpr double kThin = 0.6;                              // [pt]
constexpr double kLegendLine = 14.0;                       // height of a line of the legend [pt]
constexpr double kSwatch = 18.0;                           // [pt]
constexpr double kLetter = 0.62 * PlotDrawing::kTextSize;  // of a usual text, rather wide [pt]
constexpr int kXTicks = 8;
constexpr int kYTicks = 6;
constexpr double kForcePadding = 0.06;  // of the forces, above and below

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void hold(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double size() const { return high - low; }
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
};

bool isFinite(const PlotPoint& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

/// Where the way from one point to another crosses a border.
PlotPoint at(double x, const PlotPoint& from, const PlotPoint& to) {
    return {x, std::lerp(from.y, to.y, (x - from.x) / (to.x - from.x))};
}

/// The part of the way from one point to another that lies within the range.
std::vector<PlotPoint> within(const Range& range, PlotPoint from, PlotPoint to) {
    const PlotPoint start = from;
    const PlotPoint end = to;
    for (const double border : {range.low, range.high}) {
        const bool isLow = border == range.low;
        const auto isOut = [&](const PlotPoint& point) {
            return isLow ? point.x < border : point.x > border;
        };
        if (isOut(from) && isOut(to)) {
            return {};
        }
        if (isOut(from)) {
            from = at(border, start, end);
        } else if (isOut(to)) {
            to = at(border, start, end);
        }
    }
    return {from, to};
}

/// The pieces of a curve within the range.
std::vector<std::vector<PlotPoint>> pieces(const std::vector<PlotPoint>& points,
                                           const Range& range) {
    std::vector<std::vector<PlotPoint>> all;
    bool goesOn = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (!isFinite(points[i - 1]) || !isFinite(points[i])) {
            goesOn = false;
            continue;
        }
        const std::vector<PlotPoint> part = within(range, points[i - 1], points[i]);
        if (part.empty()) {
            goesOn = false;
            continue;
        }
        if (!goesOn) {
            all.push_back({part[0]});
        }
        all.back().push_back(part[1]);
        goesOn = range.holds(points[i].x);
    }
    return all;
}

Range distancesOf(const Plot& plot) {
    if (plot.low < plot.high) {
        return {plot.low, plot.high};
    }
    Range range;
    for (const PlotCurve& curve : plot.curves) {
        for (const PlotPoint& point : curve.points) {
            if (isFinite(point)) {
                range.hold(point.x);
            }
        }
    }
    return range.size() > 0.0 ? range : Range{0.0, 1.0};
}

std::size_t lettersOf(std::string_view text) {
    std::size_t letters = 0;
    while (!text.empty()) {
        text.remove_prefix(std::max<std::size_t>(1, firstCharacter(text).length));
        ++letters;
    }
    return letters;
}

/// Lays a plot out piece by piece.
class Layout {
public:
    explicit Layout(const Plot& plot) : plot_(plot), x_(distancesOf(plot)) {
        for (const PlotCurve& curve : plot.curves) {
            curves_.push_back(pieces(curve.points, x_));
        }
        y_ = forces();
    }

    PlotDrawing drawn() {
        legend();
        drawing_.width = kWidth;
        drawing_.height = top_ + kHeight;
        axis(plot_.x, x_, kXTicks, true);
        axis(plot_.y, y_, kYTicks, false);
        frame();
        for (std::size_t i = 0; i < curves_.size(); ++i) {
            for (const auto& piece : curves_[i]) {
                curve(piece, plot_.curves[i]);
            }
        }
        for (const PlotMark& mark : plot_.marks) {
            if (isFinite(mark.place) && x_.holds(mark.place.x)) {
                drawing_.rings.push_back({placed(mark.place), mark.ink});
            }
        }
        return std::move(drawing_);
    }

private:
    /// Of what is seen; zero is in sight.
    [[nodiscard]] Range forces() const {
        Range range{0.0, 0.0};
        for (const auto& curve : curves_) {
            for (const auto& piece : curve) {
                for (const PlotPoint& point : piece) {
                    range.hold(point.y);
                }
            }
        }
        for (const PlotMark& mark : plot_.marks) {
            if (isFinite(mark.place) && x_.holds(mark.place.x)) {
                range.hold(mark.place.y);
            }
        }
        const double room = range.size() > 0.0 ? kForcePadding * range.size() : 1.0;
        return {range.low - room, range.high + room};
    }

    [[nodiscard]] PlotPoint placed(const PlotPoint& point) const {
        const double width = kWidth - kLeft - kRight;
        const double height = kHeight - kTop - kBottom;
        return {kLeft + width * (point.x - x_.low) / x_.size(),
                top_ + kTop + height * (y_.high - point.y) / y_.size()};
    }

    void line(std::vector<PlotPoint> points, PlotInk ink, double width) {
        drawing_.lines.push_back({std::move(points), ink, width});
    }

    void curve(const std::vector<PlotPoint>& piece, const PlotCurve& style) {
        std::vector<PlotPoint> points(piece.size());
        std::ranges::transform(piece, points.begin(),
                               [this](const PlotPoint& point) { return placed(point); });
        line(std::move(points), style.ink, style.width);
    }

    void legend() {
        double right = kLeft;
        double baseline = 10.0;
        for (const PlotCurve& curve : plot_.curves) {
            if (curve.name.empty() || curve.points.empty()) {
                continue;
            }
            const double room =
                kSwatch + 20.0 + kLetter * static_cast<double>(lettersOf(curve.name));
            if (right > kLeft && right + room > kWidth) {
                right = kLeft;
                baseline += kLegendLine;
            }
            line({{right, baseline - 3.0}, {right + kSwatch, baseline - 3.0}}, curve.ink,
                 curve.width);
            drawing_.texts.push_back({curve.name, {right + kSwatch + 5.0, baseline}});
            right += room;
            top_ = baseline + 4.0;
        }
    }

    /// Ticks, grid, numbers and title.
    void axis(const PlotAxis& axis, const Range& range, int count, bool isX) {
        const SiScale scale =
            siScaleFor(std::max(std::abs(range.low), std::abs(range.high)), axis.unit);
        const std::vector<double> ticks =
            niceTicks(range.low * scale.factor, range.high * scale.factor, count);
        const std::vector<std::string> labels = tickLabels(ticks);
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            tick(ticks[i] / scale.factor, labels[i], isX);
        }
        const std::string title = axis.title + " [" + scale.unit + "]";
        const double middle = 0.5 * (top_ + kTop + top_ + kHeight - kBottom);
        if (isX) {
            drawing_.texts.push_back({title,
                                      {0.5 * (kLeft + kWidth - kRight), top_ + kHeight - 6.0},
                                      TextAnchor::Middle});
        } else {
            drawing_.texts.push_back(
                {title, {10.0, middle}, TextAnchor::Middle, PlotInk::Ink, true});
        }
    }

    void tick(double value, const std::string& label, bool isX) {
        const PlotPoint low = placed({isX ? value : x_.low, isX ? y_.low : value});
        const PlotPoint high = placed({isX ? value : x_.high, isX ? y_.high : value});
        line({low, high}, value == 0.0 ? PlotInk::Muted : PlotInk::Faint, kThin);
        if (isX) {
            line({low, {low.x, low.y + kTick}}, PlotInk::Muted, kThin);
            drawing_.texts.push_back(
                {label, {low.x, low.y + kTick + 9.0}, TextAnchor::Middle, PlotInk::Muted});
        } else {
            line({{low.x - kTick, low.y}, low}, PlotInk::Muted, kThin);
            drawing_.texts.push_back(
                {label, {low.x - kTick - 3.0, low.y + 3.0}, TextAnchor::End, PlotInk::Muted});
        }
    }

    void frame() {
        line({placed({x_.low, y_.high}), placed({x_.low, y_.low}), placed({x_.high, y_.low})},
             PlotInk::Muted, kThin);
    }

    const Plot& plot_;
    Range x_;
    Range y_;
    std::vector<std::vector<std::vector<PlotPoint>>> curves_;  ///< the pieces of each
    PlotDrawing drawing_;
    double top_ = 0.0;  ///< below the legend [pt]
};

}  // namespace

PlotDrawing layOut(const Plot& plot) { return Layout(plot).drawn(); }

}  // namespace asperity
