#pragma once

#include "vtkplugins/pictures/ColorBar.h"
#include "vtkplugins/pictures/Painter.h"
#include "vtkplugins/pictures/PictureParts.h"

#include <string>
#include <vector>

namespace asperity {

enum class LegendMark : std::uint8_t { Line, DashedLine, Point };

struct LegendEntry {
    Color color;
    std::string text;
    LegendMark mark = LegendMark::Line;
};

/// Height that the legend needs within this width, before any text can be measured [pixel].
[[nodiscard]] double legendHeightFor(const std::vector<LegendEntry>& entries, double width);

/// Draws the entries one after the other, in as many rows as they need, from the top of `area`.
void paintLegend(Painter& painter, const std::vector<LegendEntry>& entries, const PixelRect& area);

/// What stands around a 3-D scene.
struct PanelText {
    std::string title;
    std::vector<LegendEntry> legend;
    ColorBar bar;
    std::string caption;
};

/// Where the parts of a panel with a 3-D scene lie.
class PanelLayout {
public:
    explicit PanelLayout(const PixelRect& panel, const PictureParts& parts = {});

    /// The place of the 3-D scene.
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
