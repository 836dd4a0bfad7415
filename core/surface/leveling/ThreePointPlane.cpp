#include "core/surface/leveling/ThreePointPlane.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/surface/leveling/CountedPixels.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

std::string placeText(const Vector2& point) {
    return "(" + formatSi(point.x(), "m") + ", " + formatSi(point.y(), "m") + ")";
}

/// Mean place and height of the pixels around a place.
struct Support {
    Vector2 place;        ///< [m]
    double height = 0.0;  ///< [m]
};

template <class Heights>
Support supportAt(const BasicHeightMap<Heights>& map, const Vector2& point) {
    const double right = point.x() / map.pitchX;
    const double down = map.rows - point.y() / map.pitchY;
    if (!(right >= 0.0 && right <= map.columns && down >= 0.0 && down <= map.rows)) {
        throw Error("three_point: the place " + placeText(point) + " lies outside the scan");
    }
    const int column = std::min(static_cast<int>(right), map.columns - 1);
    const int row = std::min(static_cast<int>(down), map.rows - 1);
    Vector2 place = Vector2::Zero();
    double height = 0.0;
    double count = 0.0;
    for (int r = row - 1; r <= row + 1; ++r) {
        for (int c = column - 1; c <= column + 1; ++c) {
            if (r < 0 || c < 0 || r >= map.rows || c >= map.columns || !counts(map, r, c)) {
                continue;
            }
            place += Vector2((c + 0.5) * map.pitchX, (map.rows - r - 0.5) * map.pitchY);
            height += map.at(r, c);
            count += 1.0;
        }
    }
    if (count == 0.0) {
        throw Error("three_point: no pixel around the place " + placeText(point) + " holds data");
    }
    return {.place = place / count, .height = height / count};
}

}  // namespace

template <class Heights>
PlaneFit threePointPlane(const BasicHeightMap<Heights>& map, const LevelPoints& points) {
    requireUsable(map);
    if (const std::string refusal = refusalOf(points); !refusal.empty()) {
        throw Error(refusal);
    }
    const Support a = supportAt(map, points[0]);
    const Support b = supportAt(map, points[1]);
    const Support c = supportAt(map, points[2]);
    const Vector2 ab = b.place - a.place;
    const Vector2 ac = c.place - a.place;
    const double longest = std::max({ab.norm(), ac.norm(), (c.place - b.place).norm()});
    const double twiceArea = ab.x() * ac.y() - ab.y() * ac.x();
    if (!(std::abs(twiceArea) > std::min(map.pitchX, map.pitchY) * longest)) {
        throw Error("three_point needs three places that do not lie on one line within a pixel");
    }
    const double riseB = b.height - a.height;
    const double riseC = c.height - a.height;
    const Vector2 center = (a.place + b.place + c.place) / 3.0;
    return {.slopeX = (riseB * ac.y() - riseC * ab.y()) / twiceArea,
            .slopeY = (riseC * ab.x() - riseB * ac.x()) / twiceArea,
            .mean = a.height + (riseB + riseC) / 3.0,
            .centerX = center.x(),
            .centerY = center.y()};
}

template PlaneFit threePointPlane(const BasicHeightMap<std::vector<double>>&, const LevelPoints&);
template PlaneFit threePointPlane(const BasicHeightMap<PixelVector<float>>&, const LevelPoints&);

}  // namespace asperity
