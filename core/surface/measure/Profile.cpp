#include "core/surface/measure/Profile.h"

#include "core/FiniteVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

/// A place this close to a pixel center is on it: rounding must not ask for its neighbor [pixel].
constexpr double kOnCenter = 1e-9;

/// The two pixels around a place along one axis, and the share of the second.
struct Between {
    int first = 0;
    int second = 0;
    double share = 0.0;
};

/// @param place in pixels from the center of the first one
Between between(double place, int count) {
    const double inside = std::clamp(place, 0.0, count - 1.0);
    const int first = static_cast<int>(inside + kOnCenter);
    const double share = inside - first;
    return {.first = first,
            .second = std::min(first + 1, count - 1),
            .share = share > kOnCenter ? share : 0.0};
}

}  // namespace

void requireLine(const Vector2& from, const Vector2& to, int samples) {
    if (samples < 2) {
        throw Error("a profile needs at least two samples");
    }
    if (!isFinite(from) || !isFinite(to) || !((to - from).norm() > 0.0)) {
        throw Error("a profile needs two places apart from each other");
    }
}

Profile profileOf(const BSplineSurface& surface, const Vector2& from, const Vector2& to,
                  int samples) {
    return profileOf(
        [&surface](double x, double y) {
            const bool known = surface.contains(x, y) && surface.isMeasured(x, y);
            return known ? surface.at(x, y).height : kNoData;
        },
        from, to, samples);
}

double bilinearHeight(const HeightMap& map, double x, double y) {
    if (!(x >= 0.0 && x <= map.sizeX() && y >= 0.0 && y <= map.sizeY())) {
        return kNoData;
    }
    const Between columns = between(x / map.pitchX - 0.5, map.columns);
    const Between rows = between(map.rows - 0.5 - y / map.pitchY, map.rows);
    double height = 0.0;
    for (const auto& [row, rowShare] :
         {std::pair{rows.first, 1.0 - rows.share}, std::pair{rows.second, rows.share}}) {
        for (const auto& [column, columnShare] : {std::pair{columns.first, 1.0 - columns.share},
                                                  std::pair{columns.second, columns.share}}) {
            const double share = rowShare * columnShare;
            if (share == 0.0) {
                continue;
            }
            if (!map.isValid(row, column) || !isFiniteHeight(map.at(row, column))) {
                return kNoData;
            }
            height += share * map.at(row, column);
        }
    }
    return height;
}

int usualSamples(double pitchX, double pitchY, const Vector2& from, const Vector2& to) {
    constexpr double kMax = 1e6;
    const double pixels = std::hypot((to.x() - from.x()) / pitchX, (to.y() - from.y()) / pitchY);
    return 1 + static_cast<int>(std::clamp(std::ceil(pixels), 1.0, kMax));
}

}  // namespace asperity
