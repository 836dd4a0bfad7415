#pragma once

#include "app/reports/page/PlotDrawing.h"

#include <string>

namespace asperity {

/// A plot as an <svg> within HTML. Colors are classes, see svgStyle(). @param description for those
/// who do not see it
[[nodiscard]] std::string svgPlot(const PlotDrawing& drawing, const std::string& description);

/// The rules of a style sheet that give these classes the colors of a palette.
[[nodiscard]] std::string svgStyle(const Palette& colors);

}  // namespace asperity
