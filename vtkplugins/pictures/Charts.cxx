#include "vtkplugins/pictures/Charts.h"

#include "core/Error.h"
#include "vtkplugins/pictures/ChartPanel.h"

#include <algorithm>
#include <memory>

namespace asperity {

namespace {

constexpr double kChartsEdge = 20.0;

void check(const Chart& chart) {
    for (const Curve& curve : chart.curves) {
        if (curve.x.size() != curve.y.size() ||
            (!curve.pointLabels.empty() && curve.pointLabels.size() != curve.x.size())) {
            throw Error("The chart \"" + chart.title +
                        "\" cannot be drawn: the arrays of its curve \"" + curve.label +
                        "\" differ in length.");
        }
    }
}

}  // namespace

void writeCharts(const std::filesystem::path& path, std::span<const Chart> charts, int columns,
                 PictureSize size) {
    if (charts.empty() || columns < 1) {
        throw Error("A page of charts needs at least one chart and one column.");
    }
    std::for_each(charts.begin(), charts.end(), check);
    OffscreenPicture picture(size);
    const int rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
    const double width = (size.width - 2.0 * kChartsEdge) / columns;
    const double height = (size.height - 2.0 * kChartsEdge) / rows;
    for (std::size_t i = 0; i < charts.size(); ++i) {
        const int row = static_cast<int>(i) / columns;
        const int column = static_cast<int>(i) % columns;
        const PixelRect area{kChartsEdge + column * width,
                             size.height - kChartsEdge - (row + 1) * height, width, height};
        const auto panel = std::make_shared<ChartPanel>(picture, charts[i], area);
        picture.paint([panel](Painter& painter) { panel->paint(painter); });
    }
    picture.writePng(path);
}

}  // namespace asperity
