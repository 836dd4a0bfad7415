#include "ui/view/SurfaceColors.h"

#include "vtkplugins/pictures/Palette.h"

#include <vtkLookupTable.h>

#include <QObject>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinHeightRange = 1e-10;        // [m]
constexpr double kMinDisplacementRange = 1e-10;  // [m]
constexpr int kScaleColors = 64;
constexpr double kFaint = 0.1;  // part of the range below which a displacement leaves no color

/// Fits a range. @return whether that changed it
bool refit(SteadyRange& range, double low, double high) {
    const AxisRange before = range.range();
    const AxisRange& after = range.fit(low, high);
    return before.low != after.low || before.high != after.high;
}

Color colorIn(vtkLookupTable* table, double value) {
    const unsigned char* rgb = table->MapValue(value);
    return {rgb[0], rgb[1], rgb[2]};
}

ColorScale scaleOf(const QString& quantity, vtkLookupTable* table) {
    ColorScale scale{.quantity = quantity,
                     .unit = "m",
                     .low = table->GetRange()[0],
                     .high = table->GetRange()[1]};
    for (int i = 0; i < kScaleColors; ++i) {
        const int entry =
            i * (static_cast<int>(table->GetNumberOfColors()) - 1) / (kScaleColors - 1);
        std::array<double, 4> rgba{};
        table->GetTableValue(entry, rgba.data());
        scale.colors.push_back(QColor::fromRgbF(rgba[0], rgba[1], rgba[2]));
    }
    return scale;
}

}  // namespace

SurfaceColors::SurfaceColors()
    : heightRange_(kMinHeightRange)
    , displacementRange_(kMinDisplacementRange)
    , heights_(heightTable(heightRange_.range().low, heightRange_.range().high))
    , displacements_(divergingTable(displacementRange_.range().high)) {}

bool SurfaceColors::fitHeights(double low, double high) {
    if (!refit(heightRange_, low, high)) {
        return false;
    }
    heights_ = heightTable(heightRange_.range().low, heightRange_.range().high);
    return true;
}

bool SurfaceColors::fitDisplacement(double largest) {
    if (!refit(displacementRange_, -largest, largest)) {
        return false;
    }
    displacements_ = divergingTable(displacementRange_.range().high);
    return true;
}

Color SurfaceColors::at(double height, double displacement) const {
    return moved(colorIn(heights_, height), displacement);
}

Color SurfaceColors::of(const BSplineSurface& surface, const Vector3& rest,
                        double displacement) const {
    return surface.isMeasured(rest.x(), rest.y()) ? at(rest.z(), displacement)
                                                  : moved(palette::kNoData, displacement);
}

/// Goes over from the color at rest to that of the displacement.
Color SurfaceColors::moved(const Color& rest, double displacement) const {
    const double part = std::min(1.0, std::abs(displacement) / displacementRange_.range().high);
    if (part <= kFaint) {
        return rest;
    }
    const double weight = 1.0 - std::pow((1.0 - part) / (1.0 - kFaint), 4);
    const Color pushed = colorIn(displacements_, displacement);
    const auto mix = [weight](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(double(from), double(to), weight)));
    };
    return {mix(rest.red, pushed.red), mix(rest.green, pushed.green), mix(rest.blue, pushed.blue)};
}

ColorScale SurfaceColors::heightScale() const { return scaleOf(QObject::tr("height"), heights_); }

ColorScale SurfaceColors::displacementScale() const {
    return scaleOf(QObject::tr("displacement"), displacements_);
}

}  // namespace asperity
