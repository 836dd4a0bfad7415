#pragma once

#include "app/charts/Chart.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace asperity {

/// A page of charts as boxes, lines, dots and letters. Positions are in pixels of 1/96 inch from
/// the upper left corner.
struct ChartPage {
    struct Point {
        double x = 0.0;
        double y = 0.0;
    };
    struct Box {
        double left = 0.0;
        double top = 0.0;
        double width = 0.0;
        double height = 0.0;
        Color color;
    };
    struct Line {
        std::vector<Point> points;
        Color color;
        double width = 1.0;
        bool dashed = false;
    };
    struct Dot {
        Point center;
        double radius = 0.0;
        Color color;
        double line = 0.0;  ///< width of a ring's line; 0: filled
    };
    enum class Anchor : std::uint8_t { Start, Middle, End };
    struct Text {
        Point at;  ///< its middle height, where it is anchored
        std::string text;
        double size = 0.0;  ///< of the font
        Color color;
        bool bold = false;
        Anchor anchor = Anchor::Start;
        bool upright = false;  ///< reads upwards
    };

    double width = 0.0;
    double height = 0.0;
    std::vector<std::variant<Box, Line, Dot, Text>>
        parts;  ///< in the order in which they are drawn
};

/// Divides a cell of a chart with names on both axes: from below, each key gets its share of the
/// height. @param shares >= 0, of whatever total; none: the cell stays empty
void addShares(Chart& chart, std::size_t column, std::size_t row, std::span<const double> shares,
               std::span<const ChartKey> keys);

/// Lays charts out in rows and columns: axes with round numbers in fitting units, legends above.
/// @throw Error when a curve's arrays differ in length, or the page is too small to be read
[[nodiscard]] ChartPage layOut(std::span<const Chart> charts, const ChartSheet& sheet);

}  // namespace asperity
