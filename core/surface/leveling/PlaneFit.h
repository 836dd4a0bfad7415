#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"
#include "core/surface/leveling/LevelingStep.h"

#include <array>

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

/// The plane of the prevailing slope, relative to the map's datum; its height at the center of the
/// valid pixels is their mean.
///
/// That slope is Gwyddion's: the mean of the slopes of all squares of 2 x 2 valid pixels with the
/// weights exp(-d^2 / s^2), d being a square's distance from that mean and s^2 a twentieth of the
/// mean d^2. It is found, from a level plane on, to 1e-6 s. On flat tops and bottoms with steps
/// between them it is the slope of the flats. Two threads, the same to the last bit on any number.
/// @throw Error when the map is unusable or no pixel is valid; Canceled
template <class Heights>
[[nodiscard]] PlaneFit facetPlane(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

/// The plane through the heights at three positions, relative to the map's datum. A position counts
/// as the valid pixels among the 3 x 3 around it: their mean height at the mean of their centers,
/// so that the plane of a tilted plane is that plane.
/// @throw Error when a position is outside the scan or has no valid pixel, or all three are on a
///        line within a pixel
template <class Heights>
[[nodiscard]] PlaneFit threePointPlane(const BasicHeightMap<Heights>& map,
                                       const LevelPoints& points);

/// A polynomial of second degree through the heights of a map, relative to the map's datum.
class QuadraticFit {
public:
    /// The least-squares one of the valid pixels; where they do not determine it, the smallest.
    /// @throw Error when the map is unusable or no pixel is valid; Canceled
    template <class Heights>
    explicit QuadraticFit(const BasicHeightMap<Heights>& map, Progress* progress = nullptr);

    /// Height at the center of the pixel (row, column), row 0 at the top [m].
    [[nodiscard]] double at(int row, int column) const {
        const double u = (column - middleColumn_) / halfColumns_;
        const double v = (middleRow_ - row) / halfRows_;
        return origin_ + terms_[0] + u * (terms_[1] + terms_[3] * u + terms_[4] * v) +
               v * (terms_[2] + terms_[5] * v);
    }

    /// At the center of the scan, world frame.
    [[nodiscard]] double height() const { return origin_ + terms_[0]; }  ///< [m]
    [[nodiscard]] double slopeX() const { return terms_[1] / halfWidth_; }
    [[nodiscard]] double slopeY() const { return terms_[2] / halfHeight_; }
    /// Second derivatives [1/m].
    [[nodiscard]] double bendX() const { return 2.0 * terms_[3] / (halfWidth_ * halfWidth_); }
    [[nodiscard]] double bendY() const { return 2.0 * terms_[5] / (halfHeight_ * halfHeight_); }
    [[nodiscard]] double twist() const { return terms_[4] / (halfWidth_ * halfHeight_); }

private:
    double middleColumn_;
    double middleRow_;
    double halfColumns_;  ///< u and v are positions over these: -1 to 1
    double halfRows_;
    double halfWidth_;   ///< [m]
    double halfHeight_;  ///< [m]
    double origin_;      ///< [m]
    /// Coefficients of 1, u, v, u^2, u v, v^2 [m].
    std::array<double, 6> terms_{};
};

}  // namespace asperity
