#pragma once

#include "vtkplugins/pictures/ChartAxis.h"
#include "vtkplugins/pictures/Charts.h"
#include "vtkplugins/pictures/LabelPlacer.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"

#include <vector>

namespace asperity {

/// One chart of a page: a VTK chart with our own text.
class ChartPanel {
public:
    ChartPanel(OffscreenPicture& picture, const Chart& chart, const PixelRect& area);

    /// Title, legend, names and numbers of the axes, point labels.
    void paint(Painter& painter) const;

private:
    /// The rectangle between the axes.
    [[nodiscard]] PixelRect plotArea() const;
    [[nodiscard]] double legendHeight() const;
    [[nodiscard]] std::vector<LegendEntry> legend() const;
    [[nodiscard]] Color colorOf(std::size_t curve) const;
    /// Pixel of a place in the axes' own numbers.
    [[nodiscard]] PixelPoint pixelOf(double x, double y) const;
    void addPlots(OffscreenPicture& picture) const;
    void paintAxes(Painter& painter) const;
    void blockWhatIsDrawn(LabelPlacer& placer) const;
    void paintPointLabels(Painter& painter) const;

    const Chart& chart_;
    PixelRect area_;
    ChartAxis x_;
    ChartAxis y_;
};

}  // namespace asperity
