#include "ui/view/SurfacePick.h"

#include "core/scene/Scene.h"
#include "ui/view/ColorScale.h"
#include "ui/widgets/Steady.h"

#include <vtkRenderer.h>

#include <QObject>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kKnownHeight = 1e-11;   ///< heights of a scan are known no better [m]
constexpr double kOfPixel = 0.1;         ///< to which a position in the scan means something
constexpr double kRoundingSlack = 1e-6;  ///< of the logarithm of a power of ten
constexpr double kMaxDecimals = 4.0;

/// In nanometers or larger units, with no digit finer than what is known.
/// @param known smallest difference that means something [m]
QString lengthText(double meters, double known) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-9), "m");
    const double digits = std::ceil(-std::log10(known * scale.factor) - kRoundingSlack);
    return QString::fromStdString(
        scaledText(meters, scale, static_cast<int>(std::clamp(digits, 0.0, kMaxDecimals))));
}

}  // namespace

QString textOf(const SurfaceReading& reading) {
    const double across = std::max(kOfPixel * reading.pixel, kKnownHeight);
    QString text =
        QStringLiteral("x %1   y %2   z %3")
            .arg(lengthText(reading.position.x(), across), lengthText(reading.position.y(), across),
                 lengthText(reading.position.z(), kKnownHeight));
    if (!reading.quantity.isEmpty()) {
        text += QStringLiteral("   %1 %2")
                    .arg(reading.quantity, shownValue(reading.value, reading.unit));
    }
    return text;
}

SurfaceRay rayThrough(vtkRenderer& renderer, const Vector2& pixel, const DrawnSpace& space) {
    const auto worldAt = [&](double depth) {
        renderer.SetDisplayPoint(pixel.x(), pixel.y(), depth);
        renderer.DisplayToWorld();
        const double* world = renderer.GetWorldPoint();
        return Vector3(world[0] / world[3], world[1] / world[3],
                       world[2] / world[3] / space.heightScale);
    };
    const Vector3 eye = worldAt(0.0);
    return {.origin = eye, .direction = worldAt(1.0) - eye};
}

std::optional<Vector2> seenPosition(const BSplineSurface& surface, const SurfaceRay& ray,
                                    const ScanWindow& window, const ContactShape* contact) {
    const auto hit = [&](const Vector3& moved) {
        return firstHit(surface, {ray.origin - moved, ray.direction}, {window.left, window.bottom},
                        {window.right, window.top});
    };
    std::optional<Vector3> position = hit(Vector3::Zero());
    // Where the tip has moved the surface, the ray meets it elsewhere.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds && position && contact != nullptr; ++round) {
        if (!holds(contact->area(), position->head<2>())) {
            break;
        }
        const std::optional<Vector3> next = hit(contact->moved(*position) - *position);
        if (!next) {
            break;
        }
        position = next;
    }
    return position ? std::optional<Vector2>(position->head<2>()) : std::nullopt;
}

SurfaceReading readingAt(const Scene& scene, const SurfaceField& field, const ContactShape* contact,
                         const Vector2& position) {
    const HeightSample sample = scene.surface.at(position.x(), position.y());
    const Vector3 rest(position.x(), position.y(), sample.height);
    const BSplineSurface::Grid& grid = scene.surface.grid();
    SurfaceReading reading{
        .position = rest, .pixel = std::min(grid.pitchX, grid.pitchY), .quantity = {}, .unit = {}};
    const bool isNearTip = contact != nullptr && holds(contact->area(), position);
    const double pushed =
        isNearTip ? (rest - contact->moved(rest)).dot(contact->contact().normal) : 0.0;
    if (field.quantity() == SurfaceQuantity::Height) {
        if (isNearTip) {
            reading.quantity = QObject::tr(nameOf(SurfaceQuantity::Displacement));
            reading.unit = QStringLiteral("m");
            reading.value = pushed;
        }
        return reading;
    }
    reading.quantity = QString::fromStdString(field.name());
    reading.unit = QString::fromStdString(field.unit());
    reading.value =
        isNearTip ? PatchColors::valueOf(scene, *contact, field, rest, sample.normal(), pushed)
                  : valueAt(field, scene.surface, rest, sample.normal());
    return reading;
}

}  // namespace asperity
