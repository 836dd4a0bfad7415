#pragma once

#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// One series of a chart. A sample that is not finite (on a logarithmic axis: not positive) parts
/// the line.
struct Curve {
    std::string label;  ///< in the legend; empty: not there
    std::vector<double> x;
    std::vector<double> y;            ///< as many as `x`
    std::optional<Color> color = {};  ///< empty: the next color that goes with the others
    bool dashed = false;
    bool points = false;                        ///< a dot a sample instead of a line
    bool rings = false;                         ///< a ring a sample instead of a line
    double width = 1.6;                         ///< of the line [pixel of usual letters]
    double dotSize = 7.0;                       ///< diameter of a dot [pixel of usual letters]
    std::vector<std::string> pointLabels = {};  ///< beside the dots; empty, or as many as `x`
};

/// A filled rectangle behind the curves.
struct ChartBox {
    double left = 0.0;
    double right = 0.0;
    double low = 0.0;
    double high = 0.0;
    Color color;
};

/// The part of an axis that is shown.
struct ChartRange {
    double low = 0.0;
    double high = 0.0;
};

/// Curves over a quantity, without a word on where they lie: layOut() says that of every chart.
struct Chart {
    std::string title;  ///< empty: none
    std::string xLabel;
    std::string yLabel;
    std::vector<Curve> curves;
    /// SI unit of the values ("N"): they are shown with a fitting prefix and the label gets "[nN]".
    /// Empty: values are shown as they are.
    std::string xUnit = {};
    std::string yUnit = {};
    bool logX = false;
    bool logY = false;
    std::vector<std::string> xNames = {};   ///< categories of x = 0, 1, ...
    std::vector<std::string> yNames = {};   ///< categories of y = 0, 1, ...
    std::vector<double> yHolds = {};        ///< values that the y axis reaches
    std::optional<ChartRange> xRange = {};  ///< curves are cut there; empty: all is shown
    std::vector<ChartBox> boxes = {};
};

/// The meaning of a color on all charts of a page.
struct ChartKey {
    Color color;
    std::string text;
};

/// The page that charts are drawn on.
struct ChartSheet {
    double width = 1600.0;   ///< [pixel of 1/96 inch]
    double height = 1000.0;  ///< [pixel of 1/96 inch]
    /// Bars are ticks and names of axes, labels titles and legends, the grid the lines behind.
    PictureParts parts = {};
    std::string title = {};  ///< above all charts; empty: none
    std::vector<ChartKey> keys = {};
    std::size_t columns = 0;  ///< charts side by side; 0: as suits the page
    double letters = 0.0;     ///< size of letters over the usual one; 0: as suits a chart's size
};

}  // namespace asperity
