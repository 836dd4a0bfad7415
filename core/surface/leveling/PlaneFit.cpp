#include "core/surface/leveling/PlaneFit.h"

#include "core/Error.h"
#include "core/Vector.h"
#include "core/surface/LeastSquares.h"
#include "core/surface/leveling/CountedPixels.h"

namespace asperity {

namespace {

/// Sums over valid pixels of place [pixel], seen from the middle of the map, y up, and of height.
struct Moments {
    double count = 0.0;
    Vector2 place = Vector2::Zero();
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    double height = 0.0;
    Vector2 tilt = Vector2::Zero();  ///< of place times height

    Moments& operator+=(const Moments& other) {
        count += other.count;
        place += other.place;
        square += other.square;
        height += other.height;
        tilt += other.tilt;
        return *this;
    }
};

/// Of one row; heights are taken from `origin`, so that an offset costs no digits.
template <class Heights>
Moments rowMoments(const BasicHeightMap<Heights>& map, int row, double origin) {
    double count = 0.0;
    double x = 0.0;
    double xx = 0.0;
    double z = 0.0;
    double xz = 0.0;
    const double middle = 0.5 * (map.columns - 1);
    for (int column = 0; column < map.columns; ++column) {
        if (!counts(map, row, column)) {
            continue;
        }
        const double place = column - middle;
        const double height = map.at(row, column) - origin;
        count += 1.0;
        x += place;
        xx += place * place;
        z += height;
        xz += place * height;
    }
    const double y = 0.5 * (map.rows - 1) - row;
    Moments moments{.count = count, .place = {x, count * y}, .height = z, .tilt = {xz, y * z}};
    moments.square << xx, x * y, x * y, count * y * y;
    return moments;
}

template <class Heights>
Moments mapMoments(const BasicHeightMap<Heights>& map, double origin, Progress* progress) {
    Moments sum;
    for (const Moments& one :
         ofEachRow(map.rows, progress, [&](int row) { return rowMoments(map, row, origin); })) {
        sum += one;
    }
    return sum;
}

}  // namespace

template <class Heights>
double firstHeight(const BasicHeightMap<Heights>& map) {
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            if (counts(map, row, column)) {
                return map.at(row, column);
            }
        }
    }
    throw Error("the height map holds no valid pixel");
}

template <class Heights>
PlaneFit planeOf(const BasicHeightMap<Heights>& map, Progress* progress) {
    requireUsable(map);
    const double origin = firstHeight(map);
    const Moments sums = mapMoments(map, origin, progress);
    const Vector2 center = sums.place / sums.count;
    const Eigen::Matrix2d spread = sums.square - sums.place * center.transpose();
    // The smallest solution: level across a line, should the pixels form one.
    const Vector2 perPixel = leastSquares(spread, sums.tilt - center * sums.height);
    return {.slopeX = perPixel.x() / map.pitchX,
            .slopeY = perPixel.y() / map.pitchY,
            .mean = origin + sums.height / sums.count,
            .centerX = (center.x() + 0.5 * map.columns) * map.pitchX,
            .centerY = (center.y() + 0.5 * map.rows) * map.pitchY};
}

template <class Heights>
void subtractPlane(BasicHeightMap<Heights>& map, const PlaneFit& plane, Progress* progress) {
    subtract(
        map,
        [&](int row, int column) {
            return plane.at((column + 0.5) * map.pitchX, (map.rows - row - 0.5) * map.pitchY);
        },
        progress);
}

PlaneFit fitPlane(const HeightMap& map) { return planeOf(map); }

PlaneFit fitPlane(const ScanMap& map) {
    PlaneFit plane = planeOf(map);
    plane.mean += map.datum;
    return plane;
}

template double firstHeight(const BasicHeightMap<std::vector<double>>&);
template double firstHeight(const BasicHeightMap<PixelVector<float>>&);
template PlaneFit planeOf(const BasicHeightMap<std::vector<double>>&, Progress*);
template PlaneFit planeOf(const BasicHeightMap<PixelVector<float>>&, Progress*);
template void subtractPlane(BasicHeightMap<std::vector<double>>&, const PlaneFit&, Progress*);
template void subtractPlane(BasicHeightMap<PixelVector<float>>&, const PlaneFit&, Progress*);

}  // namespace asperity
