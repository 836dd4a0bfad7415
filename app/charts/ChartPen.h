#pragma once

#include "app/charts/Chart.h"
#include "app/charts/ChartPage.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

inline constexpr double kLineHeight = 1.4;  ///< from one line to the next, of the font's size

/// Returns a width that most texts do not exceed, with any font. @param size of the font
[[nodiscard]] double estimatedWidth(const std::string& text, double size);
[[nodiscard]] double widestOf(const std::vector<std::string>& texts, double size);

/// The size of titles, all of a page alike.
struct TitleLook {
    double size = 0.0;      ///< of the font
    std::size_t lines = 0;  ///< that there is room for
};

/// Titles in one line where letters that are a little smaller suffice, else in two.
[[nodiscard]] TitleLook titleLook(const std::vector<std::string>& titles, double width,
                                  double usualSize);

/// A rectangle from its upper left corner.
struct Area {
    double left = 0.0;
    double top = 0.0;
    double width = 0.0;
    double height = 0.0;

    [[nodiscard]] double right() const { return left + width; }
    [[nodiscard]] double bottom() const { return top + height; }
    [[nodiscard]] bool holds(const Area& other) const {
        return other.left >= left && other.right() <= right() && other.top >= top &&
               other.bottom() <= bottom();
    }
    [[nodiscard]] bool overlaps(const Area& other) const {
        return left < other.right() && other.left < right() && top < other.bottom() &&
               other.top < bottom();
    }
};

/// Finds room for the names of dots, clear of dots, lines and one another.
class LabelPlacer {
public:
    explicit LabelPlacer(const Area& inside) : inside_(inside) {}

    void blockDot(const ChartPage::Point& dot, double size);
    void blockLine(const ChartPage::Point& from, const ChartPage::Point& to);

    /// Returns the first free area about the dot that is inside, else one below it.
    Area place(const ChartPage::Point& dot, double dotSize, double width, double height);

private:
    Area inside_;
    std::vector<Area> taken_;
};

/// An entry of a legend.
struct ChartLegendEntry {
    std::string text;
    Color color;
    const Curve* curve = nullptr;  ///< whose mark it has; null: a dot
};

/// Draws on a page with letters and lines of one scale.
class ChartPen {
public:
    ChartPen(ChartPage& page, double scale) : page_(page), scale_(scale) {}

    [[nodiscard]] double scaled(double length) const { return scale_ * length; }

    void box(const Area& area, const Color& color);
    void line(std::vector<ChartPage::Point> points, const Color& color, double width,
              bool dashed = false);
    void dot(const ChartPage::Point& center, const Curve& curve, const Color& color);
    ChartPage::Text& text(const ChartPage::Point& at, const std::string& text, double size,
                          ChartPage::Anchor anchor = ChartPage::Anchor::Start);

    /// Draws a title in lines of whole words. @param size of the font on the page
    void title(const ChartPage::Point& corner, const std::string& text, double size, double width);

    /// Returns the height of the rows of a legend.
    [[nodiscard]] double legendHeight(const std::vector<ChartLegendEntry>& entries,
                                      double width) const;
    void legend(const ChartPage::Point& corner, const std::vector<ChartLegendEntry>& entries,
                double width);

private:
    using Put = std::function<void(const ChartLegendEntry& entry, const ChartPage::Point& at)>;
    /// Passes each entry's position, from the left, row by row. @return height of the rows
    double layLegend(const std::vector<ChartLegendEntry>& entries, double room,
                     const Put& put) const;

    ChartPage& page_;
    double scale_;
};

/// An axis of a chart: unit prefix, logarithm, range, ticks, and where values lie along it.
class ChartAxis {
public:
    struct Request {
        std::string label;
        std::string unit;
        bool logarithmic = false;
        int maxTicks = 8;
        std::vector<std::string> names = {};   ///< of the values 0, 1, ...: ticks are these
        std::optional<ChartRange> range = {};  ///< that the axis shows; empty: all values
    };

    /// Fits the axis to all values that it can show.
    ChartAxis(const Request& request, std::span<const double> values);

    /// Returns where a value lies, in the axis's own numbers; NaN when it does not lie there.
    [[nodiscard]] double position(double value) const;

    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }
    [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }
    /// Returns whether a tick is the zero that parts values of both signs.
    [[nodiscard]] bool isZeroLine(double tick) const { return crossesZero_ && tick == 0.0; }

private:
    void setNames(const std::vector<std::string>& names);
    void setLinearTicks(int most);
    void setDecades(int most);

    bool logarithmic_;
    bool crossesZero_ = false;
    double factor_ = 1.0;
    std::string title_;
    double low_ = 0.0;
    double high_ = 1.0;
    std::vector<double> ticks_;  ///< in the axis's own numbers
    std::vector<std::string> labels_;
};

/// Samples of a curve, one x for each y.
struct Series {
    std::vector<double> x;
    std::vector<double> y;
};

/// The series thinned for drawing: of each of `buckets` equal runs of samples the first, the
/// lowest, the highest and the last stay, in their order. Short series stay as they are.
[[nodiscard]] Series decimateMinMax(const Series& series, std::size_t buckets);

}  // namespace asperity
