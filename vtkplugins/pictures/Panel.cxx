#include "vtkplugins/pictures/Panel.h"

namespace asperity {

namespace {

constexpr double kPanelEdge = 32.0;
constexpr double kTop = 14.0;
constexpr double kPanelTitle = 50.0;
constexpr double kLegend = 34.0;
constexpr double kUnderScene = 42.0;  // room for the scale bar's label
constexpr double kPanelBar = 64.0;
constexpr double kCaption = 106.0;
constexpr double kCaptionedHeight = 560.0;  // of a panel: in a lower one the scene takes its room
constexpr double kPanelBelow = 12.0;

constexpr double kLegendRow = 24.0;
constexpr double kSwatch = 28.0;
const TextStyle kLegendText{.size = 16.0, .color = kLightPalette.muted};

void paintMark(Painter& painter, const LegendEntry& entry, const PixelPoint& at) {
    if (entry.mark == LegendMark::Point) {
        painter.disc({at.x + 0.5 * kSwatch, at.y}, 5.5, entry.color);
    } else {
        painter.line({at, {at.x + kSwatch, at.y}},
                     {entry.color, 3.0, entry.mark == LegendMark::DashedLine});
    }
}

/// Places the entries from the top of `area` and hands each to `put`. @return height of the rows
template <typename Measure, typename Put>
double layLegend(const std::vector<LegendEntry>& entries, const PixelRect& area,
                 const Measure& measure, const Put& put) {
    PixelPoint at{area.left, area.top() - 0.5 * kLegendRow};
    for (const LegendEntry& entry : entries) {
        const double width = kSwatch + 8.0 + measure(entry.text);
        if (at.x > area.left && at.x + width > area.right()) {
            at = {area.left, at.y - kLegendRow};
        }
        put(entry, at);
        at.x += width + 26.0;
    }
    return area.top() - at.y + 0.5 * kLegendRow;
}

}  // namespace

double legendHeightFor(const std::vector<LegendEntry>& entries, double width) {
    constexpr double kWideLetter = 0.62;  // of the font's size: few letters are wider
    const auto estimate = [](const std::string& text) {
        return kWideLetter * kLegendText.size * static_cast<double>(text.size());
    };
    return layLegend(entries, {0.0, 0.0, width, 0.0}, estimate,
                     [](const LegendEntry&, const PixelPoint&) {});
}

void paintLegend(Painter& painter, const std::vector<LegendEntry>& entries, const PixelRect& area) {
    const auto measure = [&painter](const std::string& text) {
        return painter.textWidth(text, kLegendText);
    };
    layLegend(entries, area, measure, [&painter](const LegendEntry& entry, const PixelPoint& at) {
        paintMark(painter, entry, at);
        painter.text({at.x + kSwatch + 8.0, at.y}, entry.text, kLegendText);
    });
}

PixelRect PanelLayout::band(double fromTop, double height) const {
    return {panel_.left + kPanelEdge, panel_.top() - fromTop - height,
            panel_.width - 2.0 * kPanelEdge, height};
}

PanelLayout::PanelLayout(const PixelRect& panel, const PictureParts& parts)
    : panel_(panel)
    , parts_(parts)
    , above_(kTop + (parts.labels ? kPanelTitle + kLegend : 0.0))
    , bar_(parts.bars ? kUnderScene + kPanelBar : 0.0)
    , caption_(parts.labels && panel.height >= kCaptionedHeight ? kCaption : 0.0) {}

PixelRect PanelLayout::scene() const {
    return band(above_, panel_.height - above_ - bar_ - caption_ - kPanelBelow);
}

void PanelLayout::paint(Painter& painter, const PanelText& text) const {
    const double captionTop = panel_.height - caption_ - kPanelBelow;
    if (parts_.labels) {
        painter.paragraph(band(kTop, kPanelTitle), text.title, {.size = 26.0, .bold = true});
        paintLegend(painter, text.legend, band(kTop + kPanelTitle, kLegend));
    }
    if (parts_.bars) {
        drawColorBar(painter, text.bar, band(captionTop - kPanelBar, kPanelBar));
    }
    if (caption_ > 0.0) {
        painter.paragraph(band(captionTop, kCaption), text.caption,
                          {.size = 17.0, .color = kLightPalette.muted});
    }
}

}  // namespace asperity
