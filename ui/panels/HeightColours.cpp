#include "ui/panels/HeightColours.h"

#include <algorithm>
#include <cmath>

namespace asperity {

ColourScale heightColours(double low, double high) {
    return {.quantity = QStringLiteral("height"),
            .unit = QStringLiteral("m"),
            .low = low,
            .high = high,
            .colours = {{45, 22, 74},
                        {60, 57, 125},
                        {50, 96, 142},
                        {39, 130, 142},
                        {38, 164, 134},
                        {86, 192, 108},
                        {156, 214, 78},
                        {222, 226, 74},
                        {252, 238, 160}}};
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
