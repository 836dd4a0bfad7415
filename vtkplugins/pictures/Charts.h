#pragma once

#include "vtkplugins/pictures/Color.h"
#include "vtkplugins/pictures/PictureSize.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// One series of a chart. Samples that are not finite (on a logarithmic axis: not positive) are
/// left out; the line goes on to the next one.
struct Curve {
    std::string label;  ///< in the legend; empty: not there
    std::vector<double> x;
    std::vector<double> y;            ///< as many as `x`
    std::optional<Color> color = {};  ///< empty: the next color that goes with the others
    bool dashed = false;
    bool points = false;                        ///< a dot a sample instead of a line
    double dotSize = 9.0;                       ///< diameter of a dot [pixel]
    std::vector<std::string> pointLabels = {};  ///< beside the dots; empty, or as many as `x`
};

struct Chart {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    std::vector<Curve> curves;
    /// SI unit of the values ("N"): they are shown with a fitting prefix and the label gets "[nN]".
    /// Empty: values are shown as they are.
    std::string xUnit = {};
    std::string yUnit = {};
    bool logX = false;
    bool logY = false;
    std::vector<std::string> xNames = {};  ///< of x = 0, 1, ...: categories, on pages of plots
    std::vector<double> yHolds = {};       ///< values that its y axis reaches, on pages of plots
};

/// Draws the charts row by row on one page, `columns` side by side. Long series are thinned such
/// that every peak stays. The same charts give the same bytes.
/// @throw Error when a curve's arrays differ in length, no display answers, or the file cannot be
///        written
void writeCharts(const std::filesystem::path& path, std::span<const Chart> charts, int columns,
                 PictureSize size = {});

}  // namespace asperity
