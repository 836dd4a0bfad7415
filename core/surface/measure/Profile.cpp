#include "core/surface/measure/Profile.h"

#include "core/FiniteVector.h"
#include "core/surface/BetweenPixels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();

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
    const auto pixel = [&map](int row, int column) {
        return map.isValid(row, column) && isFiniteHeight(map.at(row, column)) ? map.at(row, column)
                                                                               : kNoData;
    };
    return bilinear(betweenPixels(onCenter(map.rows - 0.5 - y / map.pitchY), map.rows),
                    betweenPixels(onCenter(x / map.pitchX - 0.5), map.columns), pixel);
}

int usualSamples(double pitchX, double pitchY, const Vector2& from, const Vector2& to) {
    constexpr double kMax = 1e6;
    const double pixels = std::hypot((to.x() - from.x()) / pitchX, (to.y() - from.y()) / pitchY);
    return 1 + static_cast<int>(std::clamp(std::ceil(pixels), 1.0, kMax));
}

}  // namespace asperity
