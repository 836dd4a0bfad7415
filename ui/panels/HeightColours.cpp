#include "ui/panels/HeightColours.h"

#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>

namespace asperity {

ColourScale heightColours(double low, double high) {
    ColourScale scale{.quantity = QStringLiteral("height"),
                      .unit = QStringLiteral("m"),
                      .low = low,
                      .high = high,
                      .colours = {}};
    for (const Color& colour : palette::kHeights) {
        scale.colours.emplace_back(colour.red, colour.green, colour.blue);
    }
    return scale;
}

QColor colourAt(const ColourScale& scale, double value) {
    const double extent = scale.high - scale.low;
    const double share = extent > 0.0 ? std::clamp((value - scale.low) / extent, 0.0, 1.0) : 0.5;
    const auto last = scale.colours.size() - 1;
    const double place = share * static_cast<double>(last);
    const std::size_t left = std::min(static_cast<std::size_t>(place), last - 1);
    const double part = place - static_cast<double>(left);
    const QColor& from = scale.colours[left];
    const QColor& to = scale.colours[left + 1];
    return QColor::fromRgbF(std::lerp(from.redF(), to.redF(), part),
                            std::lerp(from.greenF(), to.greenF(), part),
                            std::lerp(from.blueF(), to.blueF(), part));
}

}  // namespace asperity
