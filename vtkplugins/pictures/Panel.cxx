#include "vtkplugins/pictures/Panel.h"

#include "core/SiFormat.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr double kThickness = 18.0;
constexpr double kTickDistance = 90.0;
constexpr int kMinTicks = 4;      // also of a short bar, where their labels have room
constexpr double kBetween = 8.0;  // labels, at least

Color colorOf(vtkLookupTable* table, double value) {
    std::array<unsigned char, 3> rgb{};
    const unsigned char* mapped = table->MapValue(value);
    std::copy_n(mapped, rgb.size(), rgb.begin());
    return {rgb[0], rgb[1], rgb[2]};
}

/// Round numbers from low to high whose labels do not run into each other, more than one where
/// there is room. @param length of the bar, as the labels are sized
std::vector<double> fittingTicks(Painter& painter, double low, double high, double length,
                                 const TextStyle& style) {
    const auto areApart = [&](const std::vector<double>& ticks) {
        double widest = 0.0;
        for (const std::string& label : tickLabels(ticks)) {
            widest = std::max(widest, painter.textWidth(label, style));
        }
        return ticks.size() < 2 ||
               (ticks[1] - ticks[0]) / (high - low) * length >= widest + kBetween;
    };
    int count = std::max(kMinTicks, static_cast<int>(length / kTickDistance));
    std::vector<double> ticks = niceTicks(low, high, count);
    while (ticks.size() < 2 && count < 2 * kMinTicks) {
        ticks = niceTicks(low, high, ++count);
    }
    while (!areApart(ticks) && count > 1) {
        ticks = niceTicks(low, high, --count);
    }
    return ticks;
}

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
        painter.line({at, {at.x + kSwatch, at.y}}, {entry.color, 3.0});
    }
}

}  // namespace

void drawColorBar(Painter& painter, const ColorBar& bar, const PixelRect& area) {
    const SiScale scale =
        bar.unit.empty() ? SiScale{}
                         : siScaleFor(std::max(std::abs(bar.low), std::abs(bar.high)), bar.unit);
    const TextStyle heading{.size = 16.0, .bold = true};
    const TextStyle plain{.size = 15.0, .align = Align::Center};
    const std::string name = bar.quantity + (scale.unit.empty() ? "" : " [" + scale.unit + "]");
    const double left = area.left + painter.textWidth(name, heading) + 24.0;
    const double lastLabel = 30.0;  // half a label sticks out at the right end
    const PixelRect colors{left, area.top() - kThickness, area.right() - lastLabel - left,
                           kThickness};
    painter.text({area.left, colors.bottom + 0.5 * kThickness}, name, heading);
    const int slices = static_cast<int>(colors.width);
    for (int slice = 0; slice < slices; ++slice) {
        const double value = std::lerp(bar.low, bar.high, (slice + 0.5) / slices);
        painter.fill({colors.left + slice, colors.bottom, 1.0, kThickness},
                     colorOf(bar.table, value));
    }
    const std::vector<double> ticks =
        fittingTicks(painter, bar.low * scale.factor, bar.high * scale.factor, colors.width, plain);
    const std::vector<std::string> labels = tickLabels(ticks);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double part = (ticks[i] / scale.factor - bar.low) / (bar.high - bar.low);
        const double x = colors.left + std::clamp(part, 0.0, 1.0) * colors.width;
        painter.line({{x, colors.bottom}, {x, colors.bottom - 6.0}}, {kLightPalette.muted, 1.0});
        painter.text({x, colors.bottom - 18.0}, labels[i], plain);
    }
}

void paintLegend(Painter& painter, const std::vector<LegendEntry>& entries, const PixelRect& area) {
    PixelPoint at{area.left, area.top() - 0.5 * kLegendRow};
    for (const LegendEntry& entry : entries) {
        const double width = kSwatch + 8.0 + painter.textWidth(entry.text, kLegendText);
        if (at.x > area.left && at.x + width > area.right()) {
            at = {area.left, at.y - kLegendRow};
        }
        paintMark(painter, entry, at);
        painter.text({at.x + kSwatch + 8.0, at.y}, entry.text, kLegendText);
        at.x += width + 26.0;
    }
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
