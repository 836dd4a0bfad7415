#include "ui/ColorScale.h"

#include "vtkplugins/pictures/ColorMaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace asperity {

namespace {

constexpr int kScaleColors = 64;

constexpr std::array kPrefixed = {"m", "V", "A", "N", "Pa", "Hz", "s", "W", "J", "C", "F", "T"};

}  // namespace

ColorScale scaleOf(const ColorTable& table, const QString& quantity, const QString& unit) {
    ColorScale scale{
        .quantity = quantity, .unit = unit, .low = table.low(), .high = table.high(), .colors = {}};
    for (int i = 0; i < kScaleColors; ++i) {
        const Color color =
            table.of(std::lerp(table.low(), table.high(), i / (kScaleColors - 1.0)));
        scale.colors.emplace_back(color.red, color.green, color.blue);
    }
    return scale;
}

SiScale shownScale(double magnitude, const QString& unit) {
    const std::string name = unit.toStdString();
    if (name == "rad") {
        return {180.0 / std::numbers::pi, "°"};
    }
    if (name == "1") {
        return {1.0, ""};
    }
    constexpr double kSmallEnergy = 1e-14;  // [J]
    if (name == "J" && std::abs(magnitude) < kSmallEnergy) {
        return {1e18, "aJ"};  // 1 aJ is 1 nN nm
    }
    if (std::ranges::find(kPrefixed, name) != kPrefixed.end()) {
        return siScaleFor(magnitude, name);
    }
    return {1.0, name};
}

QString shownValue(double value, const QString& unit, int digits) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    const SiScale scale = shownScale(value, unit);
    const double shown = value == 0.0 ? 0.0 : value * scale.factor;  // never "-0"
    const QString number = QString::number(shown, 'g', digits);
    return scale.unit.empty() ? number
                              : number + QLatin1Char(' ') + QString::fromStdString(scale.unit);
}

}  // namespace asperity
