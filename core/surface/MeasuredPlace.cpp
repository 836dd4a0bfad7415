#include "core/surface/MeasuredPlace.h"

#include <limits>

namespace asperity {

Vector2 nearestMeasured(const BSplineSurface& surface, const Vector2& place) {
    if (surface.isMeasured(place.x(), place.y())) {
        return place;
    }
    const BSplineSurface::Grid& grid = surface.grid();
    Vector2 nearest = place;
    double distance = std::numeric_limits<double>::max();
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2 center((column + 0.5) * grid.pitchX, (row + 0.5) * grid.pitchY);
            const double here = (center - place).squaredNorm();
            if (here < distance && surface.isMeasured(center.x(), center.y())) {
                distance = here;
                nearest = center;
            }
        }
    }
    return nearest;
}

}  // namespace asperity
