#include "app/charts/ChartPen.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <string_view>
#include <utility>
#include <variant>

namespace asperity {

namespace {

// Letters of DejaVu Sans by their width.
constexpr std::string_view kNarrowest = "ijl'|";
constexpr std::string_view kNarrow = "frt .,:;-()[]/!I";
constexpr std::string_view kWide = "mMW@%";
constexpr double kBold = 1.12;  // width of bold letters over that of usual ones
constexpr double kLegend = 12.0;
constexpr double kEntryGap = 15.0;
constexpr double kSwatch = 20.0;
constexpr double kSwatchLine = 2.4;
constexpr double kRingLine = 1.6;
constexpr double kHalfGap = 5.0;  // beside and below marks of a legend

using Point = ChartPage::Point;

/// Lines of whole words that are no wider, where no word is.
std::vector<std::string> wrapped(const std::string& text, double size, double width) {
    std::vector<std::string> lines;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (lines.empty() || estimatedWidth(lines.back() + " " + word, size) > width) {
            lines.push_back(word);
        } else {
            lines.back() += " " + word;
        }
    }
    return lines;
}

constexpr double kPadding = 0.05;  // of the range, at each end

double largestMagnitude(std::span<const double> values) {
    double largest = 0.0;
    for (const double value : values) {
        if (std::isfinite(value)) {
            largest = std::max(largest, std::abs(value));
        }
    }
    return largest;
}

}  // namespace

// Letters of other languages count as usual ones. DejaVu Sans is wider than most fonts.
double estimatedWidth(const std::string& text, double size) {
    double width = 0.0;
    for (const char byte : text) {
        const auto code = static_cast<unsigned char>(byte);
        width += (code & 0xC0U) == 0x80U                           ? 0.0
                 : kNarrowest.find(byte) != std::string_view::npos ? 0.29
                 : kNarrow.find(byte) != std::string_view::npos    ? 0.41
                 : kWide.find(byte) != std::string_view::npos      ? 0.98
                 : (code >= 'A' && code <= 'Z') || byte == 'w'     ? 0.76
                                                                   : 0.64;
    }
    return width * size;
}

double widestOf(const std::vector<std::string>& texts, double size) {
    double widest = 0.0;
    for (const std::string& text : texts) {
        widest = std::max(widest, estimatedWidth(text, size));
    }
    return widest;
}

TitleLook titleLook(const std::vector<std::string>& titles, double width, double usualSize) {
    TitleLook look;
    const auto fits = [&](std::size_t lines, double size) {
        look = {.size = size, .lines = 0};
        for (const std::string& title : titles) {
            const std::vector<std::string> set = wrapped(title, kBold * size, width);
            look.lines = std::max(look.lines, set.size());
            if (widestOf(set, kBold * size) > width) {
                return false;
            }
        }
        return look.lines <= lines;
    };
    for (const double shrunk : {1.0, 0.9, 0.8, 0.7}) {
        if (fits(1, shrunk * usualSize)) {
            return look;
        }
    }
    constexpr double kInTwoLines = 0.85;
    constexpr double kLess = 0.9;
    constexpr double kMin = 0.4;
    for (double shrunk = kInTwoLines; shrunk > kMin && !fits(2, shrunk * usualSize);) {
        shrunk *= kLess;
    }
    return look;
}

void LabelPlacer::blockDot(const Point& dot, double size) {
    taken_.push_back({dot.x - 0.5 * size, dot.y - 0.5 * size, size, size});
}

void LabelPlacer::blockLine(const Point& from, const Point& to) {
    constexpr double kBead = 4.0;  // a line is blocked as a string of beads of this size
    const int beads = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / kBead) + 1;
    for (int bead = 0; bead <= beads; ++bead) {
        const double part = static_cast<double>(bead) / beads;
        blockDot({std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)}, kBead);
    }
}

Area LabelPlacer::place(const Point& dot, double dotSize, double width, double height) {
    const double right = dot.x + dotSize;
    const double left = dot.x - dotSize - width;
    const double middle = dot.x - 0.5 * width;
    const double above = dot.y - 0.7 * dotSize - height;
    const double below = dot.y + 0.7 * dotSize;
    const double level = dot.y - 0.5 * height;
    // A long label reaches to both sides of its dot.
    const double within = std::max(inside_.left, std::min(middle, inside_.right() - width));
    const std::array<Point, 10> corners{{{right, level},
                                         {right, above},
                                         {right, below},
                                         {left, level},
                                         {left, above},
                                         {left, below},
                                         {middle, above},
                                         {middle, below},
                                         {within, above},
                                         {within, below}}};
    const auto* const free = std::ranges::find_if(corners, [&](const Point& corner) {
        const Area candidate{corner.x, corner.y, width, height};
        return inside_.holds(candidate) && std::ranges::none_of(taken_, [&](const Area& other) {
                   return candidate.overlaps(other);
               });
    });
    const Point& corner = free == corners.end() ? corners.back() : *free;
    return taken_.emplace_back(Area{corner.x, corner.y, width, height});
}

void ChartPen::box(const Area& area, const Color& color) {
    page_.parts.emplace_back(ChartPage::Box{area.left, area.top, area.width, area.height, color});
}

void ChartPen::line(std::vector<Point> points, const Color& color, double width, bool dashed) {
    page_.parts.emplace_back(ChartPage::Line{std::move(points), color, scaled(width), dashed});
}

void ChartPen::dot(const Point& center, const Curve& curve, const Color& color) {
    page_.parts.emplace_back(ChartPage::Dot{center, scaled(0.5 * curve.dotSize), color,
                                            curve.rings ? scaled(kRingLine) : 0.0});
}

ChartPage::Text& ChartPen::text(const Point& at, const std::string& text, double size,
                                ChartPage::Anchor anchor) {
    return std::get<ChartPage::Text>(
        page_.parts.emplace_back(ChartPage::Text{.at = at,
                                                 .text = text,
                                                 .size = scaled(size),
                                                 .color = kLightPalette.ink,
                                                 .anchor = anchor}));
}

void ChartPen::title(const Point& corner, const std::string& text, double size, double width) {
    double y = corner.y + 0.5 * size;
    for (const std::string& line : wrapped(text, kBold * size, width)) {
        this->text({corner.x, y}, line, size / scale_).bold = true;
        y += kLineHeight * size;
    }
}

double ChartPen::legendHeight(const std::vector<ChartLegendEntry>& entries, double width) const {
    return layLegend(entries, width, [](const ChartLegendEntry&, const Point&) {});
}

void ChartPen::legend(const Point& corner, const std::vector<ChartLegendEntry>& entries,
                      double width) {
    layLegend(entries, width, [&](const ChartLegendEntry& entry, const Point& at) {
        const Point from{corner.x + at.x, corner.y + at.y};
        const Point to{from.x + scaled(kSwatch), from.y};
        if (entry.curve == nullptr || entry.curve->points || entry.curve->rings) {
            dot({0.5 * (from.x + to.x), from.y}, entry.curve == nullptr ? Curve{} : *entry.curve,
                entry.color);
        } else {
            line({from, to}, entry.color, kSwatchLine, entry.curve->dashed);
        }
        text({to.x + scaled(kHalfGap), from.y}, entry.text, kLegend);
    });
}

double ChartPen::layLegend(const std::vector<ChartLegendEntry>& entries, double room,
                           const Put& put) const {
    const double row = scaled(kLineHeight * kLegend);
    double x = 0.0;
    double y = entries.empty() ? 0.0 : row;
    for (const ChartLegendEntry& entry : entries) {
        const double width =
            scaled(kSwatch + kEntryGap) + estimatedWidth(entry.text, scaled(kLegend));
        if (x > 0.0 && x + width > room) {
            x = 0.0;
            y += row;
        }
        put(entry, Point{x, y - 0.5 * row});
        x += width;
    }
    return y + scaled(kHalfGap);
}

ChartAxis::ChartAxis(const Request& request, std::span<const double> values)
    : logarithmic_(request.logarithmic), title_(request.label) {
    if (!request.unit.empty()) {
        const SiScale scale = siScaleFor(largestMagnitude(values), request.unit);
        factor_ = scale.factor;
        title_ += " [" + scale.unit + "]";
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        const double at = position(value);
        if (std::isfinite(at)) {
            low = std::min(low, at);
            high = std::max(high, at);
        }
    }
    if (low > high) {  // nothing to show
        low = 0.0;
        high = 1.0;
    }
    crossesZero_ = !logarithmic_ && low < 0.0 && high > 0.0;
    const double span = high - low;
    const double least = 1e-9 * std::max(std::abs(low), std::abs(high));
    const double padding = span > least ? kPadding * span : low != 0.0 ? 0.5 * std::abs(low) : 1.0;
    low_ = request.range ? position(request.range->low) : low - padding;
    high_ = request.range ? position(request.range->high) : high + padding;
    if (!request.names.empty()) {
        setNames(request.names);
    } else if (logarithmic_) {
        setDecades(request.maxTicks);
    } else {
        setLinearTicks(request.maxTicks);
    }
}

double ChartAxis::position(double value) const {
    const double shown = value * factor_;
    if (!logarithmic_) {
        return shown;
    }
    return shown > 0.0 ? std::log10(shown) : std::numeric_limits<double>::quiet_NaN();
}

void ChartAxis::setNames(const std::vector<std::string>& names) {
    low_ = -0.5;
    high_ = static_cast<double>(names.size()) - 0.5;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ticks_.push_back(static_cast<double>(i));
    }
    labels_ = names;
}

void ChartAxis::setLinearTicks(int most) {
    ticks_ = niceTicks(low_, high_, most);
    labels_ = tickLabels(ticks_);
}

void ChartAxis::setDecades(int most) {
    const bool withinFewDecades = high_ - low_ < 2.0;
    const int decades = static_cast<int>(std::floor(high_) - std::ceil(low_)) + 1;
    const int step = std::max(1, (decades + most - 1) / most);
    for (int power = static_cast<int>(std::floor(low_)); power <= high_; power += step) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double at = power + std::log10(digit);
            if ((digit == 1.0 || withinFewDecades) && at >= low_ && at <= high_) {
                ticks_.push_back(at);
                labels_.push_back(formatted("%g", digit * std::pow(10.0, power)));
            }
        }
    }
}

Series decimateMinMax(const Series& series, std::size_t buckets) {
    constexpr std::size_t kKept = 4;  // first, lowest, highest, last
    const std::size_t count = series.y.size();
    if (buckets == 0 || count <= kKept * buckets) {
        return series;
    }
    Series thinned;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const std::size_t begin = bucket * count / buckets;
        const std::size_t end = (bucket + 1) * count / buckets;
        const auto first = series.y.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = series.y.begin() + static_cast<std::ptrdiff_t>(end);
        const auto [lowest, highest] = std::minmax_element(first, last);
        std::array<std::ptrdiff_t, kKept> kept{
            std::distance(series.y.begin(), first), std::distance(series.y.begin(), lowest),
            std::distance(series.y.begin(), highest), std::distance(series.y.begin(), last) - 1};
        std::sort(kept.begin(), kept.end());
        const auto keptEnd = std::unique(kept.begin(), kept.end());
        for (auto sample = kept.begin(); sample != keptEnd; ++sample) {
            thinned.x.push_back(series.x[static_cast<std::size_t>(*sample)]);
            thinned.y.push_back(series.y[static_cast<std::size_t>(*sample)]);
        }
    }
    return thinned;
}

}  // namespace asperity
