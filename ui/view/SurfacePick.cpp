#include "ui/view/SurfacePick.h"

#include "core/scene/Scene.h"
#include "ui/view/PatchColors.h"
#include "ui/view/ViewFrame.h"

#include <vtkRenderer.h>

#include <QObject>

namespace asperity {

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

std::optional<Vector2> seenPlace(const BSplineSurface& surface, const SurfaceRay& ray,
                                 const ScanWindow& window, const ContactShape* contact) {
    const auto hit = [&](const Vector3& moved) {
        return firstHit(surface, {ray.origin - moved, ray.direction}, {window.left, window.bottom},
                        {window.right, window.top});
    };
    std::optional<Vector3> place = hit(Vector3::Zero());
    // Where the tip has moved the surface, the ray meets it elsewhere.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds && place && contact != nullptr; ++round) {
        if (!holds(contact->area(), place->head<2>())) {
            break;
        }
        const std::optional<Vector3> next = hit(contact->moved(*place) - *place);
        if (!next) {
            break;
        }
        place = next;
    }
    return place ? std::optional<Vector2>(place->head<2>()) : std::nullopt;
}

SurfaceReading readingAt(const Scene& scene, const SurfaceField& field, const ContactShape* contact,
                         const Vector2& place) {
    const HeightSample sample = scene.surface.at(place.x(), place.y());
    const Vector3 rest(place.x(), place.y(), sample.height);
    SurfaceReading reading{.place = rest, .quantity = {}, .unit = {}};
    const bool isNearTip = contact != nullptr && holds(contact->area(), place);
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
