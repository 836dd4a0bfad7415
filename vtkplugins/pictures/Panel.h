#pragma once

#include "vtkplugins/pictures/Painter.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <string>
#include <vector>

class vtkLookupTable;

namespace asperity {

/// Name, unit, range and colors of a color bar.
struct ColorBar {
    std::string quantity;  ///< "height"
    std::string unit;      ///< SI unit of the values, shown with the fitting prefix; empty: numbers
    double low = 0.0;      ///< shown range, in `unit`
    double high = 1.0;
    vtkLookupTable* table = nullptr;  ///< colors of the values
};

/// Draws the bar along `area`, low values left, its name before it and its labels below it.
void drawColorBar(Painter& painter, const ColorBar& bar, const PixelRect& area);

enum class LegendMark : std::uint8_t { Line, Point };

struct LegendEntry {
    Color color;
    std::string text;
    LegendMark mark = LegendMark::Line;
};

/// Draws the entries one after the other, in as many rows as they need, from the top of `area`.
void paintLegend(Painter& painter, const std::vector<LegendEntry>& entries, const PixelRect& area);

/// Texts and color bar around a 3-D scene.
struct PanelText {
    std::string title;
    std::vector<LegendEntry> legend;
    ColorBar bar;
    std::string caption;
};

/// Layout of the parts of a panel with a 3-D scene.
class PanelLayout {
public:
    explicit PanelLayout(const PixelRect& panel, const PictureParts& parts = {});

    /// The position of the 3-D scene.
    [[nodiscard]] PixelRect scene() const;
    void paint(Painter& painter, const PanelText& text) const;

private:
    /// A band across the panel, `fromTop` below its upper edge.
    [[nodiscard]] PixelRect band(double fromTop, double height) const;

    PixelRect panel_;
    PictureParts parts_;
    double above_;    ///< the scene: title and legend
    double bar_;      ///< height of the color bar with its scene's label above it
    double caption_;  ///< its height
};

}  // namespace asperity
