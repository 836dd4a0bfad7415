#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

namespace asperity {

/// A plane through the heights of a map, world frame.
struct PlaneFit {
    double slopeX = 0.0;   ///< along world x
    double slopeY = 0.0;   ///< along world y (up in the image)
    double mean = 0.0;     ///< of the valid heights [m]
    double centerX = 0.0;  ///< where the plane's height is `mean`: the valid pixels' center [m]
    double centerY = 0.0;  ///< [m]

    [[nodiscard]] double at(double x, double y) const {
        return mean + slopeX * (x - centerX) + slopeY * (y - centerY);
    }

    bool operator==(const PlaneFit&) const = default;
};

/// The least-squares plane of the valid pixels. Where they do not span a plane (one line of them),
/// it is level across that line.
/// @throw Error when the map is unusable or no pixel is valid
[[nodiscard]] PlaneFit fitPlane(const HeightMap& map);
[[nodiscard]] PlaneFit fitPlane(const ScanMap& map);

/// The same of heights relative to a map's datum. @throw Canceled, too
template <class Heights>
[[nodiscard]] PlaneFit planeOf(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

/// Subtracts a plane from heights relative to the same datum. @throw Canceled with some rows done
template <class Heights>
void subtractPlane(BasicHeightMap<Heights>& map, const PlaneFit& plane,
                   Progress* progress = nullptr);

/// Height of the first valid pixel, relative to the map's datum: sums that start from it lose no
/// digits to an offset [m]. @throw Error when there is none
template <class Heights>
[[nodiscard]] double firstHeight(const BasicHeightMap<Heights>& map);

}  // namespace asperity
