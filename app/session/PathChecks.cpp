#include "app/session/PathChecks.h"

#include "core/Error.h"

#include <algorithm>

namespace asperity {

void requireNear(const Scene& scene, const HandPath& path, const std::string& file) {
    const double reach = 2.0 * std::max(scene.surface.sizeX(), scene.surface.sizeY());
    for (const PathPoint& point : path) {
        const Vector2 place = point.position.head<2>();
        if (!scene.surface.contains(place.x(), place.y()) && place.norm() > reach) {
            throw InputError(file, "at " + std::to_string(point.time) + " s",
                             "the path leaves the scan by more than its width: x_m, y_m and z_m "
                             "must be metres from its lower left corner");
        }
    }
}

QPolygonF outline(const HandPath& path) {
    constexpr std::size_t kPoints = 1000;
    QPolygonF way;
    const std::size_t step = 1 + path.size() / kPoints;
    for (std::size_t i = 0; i < path.size(); i += step) {
        way << QPointF(path[i].position.x(), path[i].position.y());
    }
    return way;
}

}  // namespace asperity
