#pragma once

#include "app/reports/page/Plot.h"

#include <string>
#include <vector>

namespace asperity {

/// A line of a plot; points x to the right, y down [pt].
struct DrawnLine {
    std::vector<PlotPoint> points;
    PlotInk ink = PlotInk::Ink;
    double width = 1.0;  ///< [pt]
};

/// Which point of a text lies at its place.
enum class TextAnchor { Start, Middle, End };

struct DrawnText {
    std::string text;
    PlotPoint place;  ///< on the baseline [pt]
    TextAnchor anchor = TextAnchor::Start;
    PlotInk ink = PlotInk::Ink;
    bool upward = false;  ///< turned by a quarter, reads from below
};

struct DrawnRing {
    PlotPoint place;  ///< [pt]
    PlotInk ink = PlotInk::Ink;
};

/// A plot as lines and texts, for any painter. World: x to the right, y down [pt].
struct PlotDrawing {
    static constexpr double kTextSize = 8.5;    ///< [pt]
    static constexpr double kRingRadius = 3.0;  ///< [pt]
    static constexpr double kRingWidth = 1.2;   ///< [pt]

    double width = 0.0;   ///< [pt]
    double height = 0.0;  ///< [pt]
    std::vector<DrawnLine> lines;
    std::vector<DrawnRing> rings;
    std::vector<DrawnText> texts;
};

/// Axes with round numbers in fitting units, zero line, curves within the range, legend above.
[[nodiscard]] PlotDrawing layOut(const Plot& plot);

}  // namespace asperity
