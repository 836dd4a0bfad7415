#include "ui/panels/HeightColors.h"

#include "ui/Theme.h"

#include <QObject>

#include <algorithm>
#include <cmath>

namespace asperity {

ColorScale heightColors(double low, double high) {
    ColorScale scale{.quantity = QObject::tr("height"),
                     .unit = QStringLiteral("m"),
                     .low = low,
                     .high = high,
                     .colors = {}};
    for (const Color& color : palette::kHeights) {
        scale.colors.push_back(toQColor(color));
    }
    return scale;
}

QColor colorAt(const ColorScale& scale, double value) {
    const double extent = scale.high - scale.low;
    const double share = extent > 0.0 ? std::clamp((value - scale.low) / extent, 0.0, 1.0) : 0.5;
    const auto last = scale.colors.size() - 1;
    const double place = share * static_cast<double>(last);
    const std::size_t left = std::min(static_cast<std::size_t>(place), last - 1);
    const double part = place - static_cast<double>(left);
    const QColor& from = scale.colors[left];
    const QColor& to = scale.colors[left + 1];
    return QColor::fromRgbF(std::lerp(from.redF(), to.redF(), part),
                            std::lerp(from.greenF(), to.greenF(), part),
                            std::lerp(from.blueF(), to.blueF(), part));
}

}  // namespace asperity
