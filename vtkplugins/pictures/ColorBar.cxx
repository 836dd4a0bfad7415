#include "vtkplugins/pictures/ColorBar.h"

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
constexpr int kLeastTicks = 4;    // also of a short bar, where their labels have room
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
    int count = std::max(kLeastTicks, static_cast<int>(length / kTickDistance));
    std::vector<double> ticks = niceTicks(low, high, count);
    while (ticks.size() < 2 && count < 2 * kLeastTicks) {
        ticks = niceTicks(low, high, ++count);
    }
    while (!areApart(ticks) && count > 1) {
        ticks = niceTicks(low, high, --count);
    }
    return ticks;
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

}  // namespace asperity
