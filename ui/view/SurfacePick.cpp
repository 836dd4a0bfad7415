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

/// In nanometers or larger units, to a hundredth of the unit: what is smaller is no length here.
QString lengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-9), "m");
    return QString::fromStdString(scaledText(meters, scale, scale.unit == "nm" ? 2 : 4));
}

}  // namespace

QString textOf(const SurfaceReading& reading) {
    QString text = QStringLiteral("x %1   y %2   z %3")
                       .arg(lengthText(reading.position.x()), lengthText(reading.position.y()),
                            lengthText(reading.position.z()));
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
    SurfaceReading reading{.position = rest, .quantity = {}, .unit = {}};
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
