#pragma once

#include "app/exports/SpatialLook.h"
#include "vtkplugins/pictures/Charts.h"
#include "vtkplugins/pictures/Painter.h"

#include <span>
#include <string>
#include <vector>

namespace asperity {

/// What a page of charts consists of, in the order in which it is drawn. Places are in pixels of
/// 1/96 inch from the upper left corner.
struct PlotPage {
    struct Point {
        double x = 0.0;
        double y = 0.0;
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
    };
    struct Text {
        Point at;  ///< its middle height, where it is aligned
        std::string text;
        double size = 0.0;  ///< of the font
        Color color;
        bool bold = false;
        Align align = Align::Left;
        bool upright = false;  ///< reads upwards
    };

    double width = 0.0;
    double height = 0.0;
    std::vector<Line> lines;
    std::vector<Dot> dots;
    std::vector<Text> texts;
};

/// Lays charts out in rows and columns that suit the page.
/// @param spec its size and resolution; of its parts, bars are ticks and names of axes, labels are
/// titles and legends, and the grid is the lines behind the curves
/// @throw Error when a curve's arrays differ in length, or the page is too small to be read
[[nodiscard]] PlotPage plotPage(std::span<const Chart> charts, const PictureSpec& spec);

}  // namespace asperity
