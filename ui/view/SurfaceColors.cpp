#include "ui/view/SurfaceColors.h"

#include "core/scene/Scene.h"

#include <QObject>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace asperity {

namespace {

constexpr double kMinHeightRange = 1e-10;        // [m]
constexpr double kMinDisplacementRange = 1e-10;  // [m]
constexpr double kFaint = 0.1;  // part of the range below which a displacement leaves no color

/// Fits a range. @return whether that changed it
bool refit(SteadyRange& range, double low, double high) {
    const AxisRange before = range.range();
    const AxisRange& after = range.fit(low, high);
    return before.low != after.low || before.high != after.high;
}

ColorTable tableOf(ColorMap map, const AxisRange& range) { return {map, range.low, range.high}; }

}  // namespace

SurfaceColors::SurfaceColors()
    : heightRange_(kMinHeightRange)
    , displacementRange_(kMinDisplacementRange)
    , table_(tableOf(ColorMap::Standard, heightRange_.range()))
    , displacements_(tableOf(ColorMap::Diverging, displacementRange_.range())) {}

void SurfaceColors::setLook(const SurfaceLook& look, const SurfaceField& field) {
    ranges_.setChannel(look.channel);
    look_ = look;
    field_ = field;
    ++fieldNumber_;
    table_ = ColorTable(chosen().map, range().range().low, range().range().high);
    displacements_ = ColorTable(look_.of(SurfaceQuantity::Displacement).map, displacements_.low(),
                                displacements_.high());
}

void SurfaceColors::forgetScene() {
    heightRange_ = SteadyRange(kMinHeightRange);
    displacementRange_ = SteadyRange(kMinDisplacementRange);
    displacements_ = tableOf(displacements_.map(), displacementRange_.range());
    ranges_.forget();
}

bool SurfaceColors::fitHeights(double low, double high) { return refit(heightRange_, low, high); }

bool SurfaceColors::fit(std::span<const double> values, bool isSteady) {
    const bool changed =
        ranges_.of(field_.quantity())
            .fit(values, {.colors = chosen(), .isSigned = field_.isSigned(), .isSteady = isSteady});
    const ValueRange& fitted = range().range();
    if (fitted.low != table_.low() || fitted.high != table_.high()) {
        table_ = ColorTable(chosen().map, fitted.low, fitted.high);
    }
    return changed;
}

bool SurfaceColors::fitRest(std::span<const double> values) { return fit(values, needsEnds()); }

bool SurfaceColors::needsEnds() const {
    return field_.quantity() == SurfaceQuantity::Height && chosen().rule == RangeRule::Full;
}

bool SurfaceColors::fitDisplacement(double largest) {
    if (!refit(displacementRange_, -largest, largest)) {
        return false;
    }
    displacements_ = tableOf(displacements_.map(), displacementRange_.range());
    return true;
}

bool SurfaceColors::fitLive(std::span<const double> values) {
    const auto shown = [this] {
        const ValueRange& colors = range().range();
        const ValueRange& data = range().data();
        return std::tuple(colors.low, colors.high, data.low<colors.low, data.high> colors.high,
                          liveNote());
    };
    const auto before = shown();
    fit(values, true);
    return before != shown();
}

/// Why there is nothing of a quantity that changes with the tip.
QString SurfaceColors::liveNote() const {
    if (!isLive()) {
        return {};
    }
    if (!range().hasData()) {
        return QObject::tr("no tip in the view");
    }
    const bool isZero = range().data().low == 0.0 && range().data().high == 0.0;
    return isZero && field_.quantity() == SurfaceQuantity::Pressure ? QObject::tr("no contact")
                                                                    : QString();
}

Color SurfaceColors::ofRest(double value) const {
    return std::isnan(value) ? palette::kNoData : table_.of(value);
}

Color SurfaceColors::ofLive(double value) const {
    return std::isnan(value) ? palette::kUndefined : table_.of(value);
}

Color SurfaceColors::ofDeformed(double value, double displacement) const {
    return moved(ofRest(value), displacement);
}

double SurfaceColors::movedShare(double displacement) const {
    const double part = std::min(1.0, std::abs(displacement) / displacementRange_.range().high);
    return field_.quantity() == SurfaceQuantity::Height && part > kFaint
               ? 1.0 - std::pow((1.0 - part) / (1.0 - kFaint), 4)
               : 0.0;
}

/// Goes over from the color at rest to that of the displacement.
Color SurfaceColors::moved(const Color& rest, double displacement) const {
    const double weight = movedShare(displacement);
    if (weight == 0.0) {
        return rest;
    }
    const Color pushed = displacements_.of(displacement);
    const auto mix = [weight](std::uint8_t from, std::uint8_t to) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(double(from), double(to), weight)));
    };
    return {mix(rest.red, pushed.red), mix(rest.green, pushed.green), mix(rest.blue, pushed.blue)};
}

ColorScale SurfaceColors::scale() const {
    ColorScale scale = scaleOf(table_, QString::fromStdString(field_.name()),
                               QString::fromStdString(field_.unit()));
    range().describe(scale, chosen());
    scale.note = liveNote();
    return scale;
}

ColorScale SurfaceColors::displacementScale() const {
    if (field_.quantity() != SurfaceQuantity::Height) {
        return {};
    }
    return scaleOf(displacements_, QObject::tr("displacement"), QStringLiteral("m"));
}

double valueAt(const SurfaceField& field, const BSplineSurface& surface, const Vector3& rest,
               const Vector3& normal) {
    return surface.isMeasured(rest.x(), rest.y()) ? field.at(rest, normal)
                                                  : std::numeric_limits<double>::quiet_NaN();
}

PatchColors::PatchColors(const Scene& scene, const ContactShape& shape, const SurfaceColors& colors)
    : scene_(scene), shape_(shape), colors_(colors) {
    const SurfacePatch& patch = shape.patch();
    values_.reserve(patch.rest.size());
    for (std::size_t i = 0; i < patch.rest.size(); ++i) {
        values_.push_back(valueOf(scene, shape, colors.field(), patch.rest[i], patch.normals[i],
                                  shape.displacements()[i]));
    }
}

Color PatchColors::of(std::size_t sample) const {
    return colorOf(values_[sample], shape_.displacements()[sample]);
}

Color PatchColors::of(const Vector3& rest, const Vector3& normal, double displacement) const {
    return colorOf(valueOf(scene_, shape_, colors_.field(), rest, normal, displacement),
                   displacement);
}

double PatchColors::valueOf(const Scene& scene, const ContactShape& shape,
                            const SurfaceField& field, const Vector3& rest, const Vector3& normal,
                            double displacement) {
    switch (field.quantity()) {
    case SurfaceQuantity::Gap:
        return shape.gap(rest, displacement);
    case SurfaceQuantity::Pressure:
        return shape.pressure(rest);
    case SurfaceQuantity::Displacement:
        return displacement;
    default:
        return valueAt(field, scene.surface, rest, normal);
    }
}

Color PatchColors::colorOf(double value, double displacement) const {
    return colors_.isLive() ? colors_.ofLive(value) : colors_.ofDeformed(value, displacement);
}

}  // namespace asperity
