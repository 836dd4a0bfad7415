#pragma once

#include "core/Progress.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>

namespace asperity {

/// Areal parameters of ISO 25178-2 over the pixels that hold data, each standing for its area. The
/// reference is their mean height: form is removed before, by leveling.
struct Roughness {
    double sa = 0.0;       ///< arithmetical mean height, mean of |z - mean| [m]
    double sq = 0.0;       ///< root mean square height, root of the mean of (z - mean)^2 [m]
    double sz = 0.0;       ///< maximum height, highest - lowest [m]
    double sdr = 0.0;      ///< developed interfacial area ratio, surface over its outline - 1
    double mean = 0.0;     ///< [m]
    double lowest = 0.0;   ///< [m]
    double highest = 0.0;  ///< [m]
    std::size_t pixels = 0;
    /// Squares of 2 x 2 such pixels, of which Sdr is: the surface of a square is the mean of both
    /// ways to split it into two triangles. Without one Sdr is 0.
    std::size_t squares = 0;
};

[[nodiscard]] PixelRectangle allPixels(const HeightRows& map);

/// The pixels whose centers lie between two opposite corners, world frame [m].
/// @throw Error when there is none, or a corner is not finite
[[nodiscard]] PixelRectangle pixelsBetween(const HeightRows& map, const Vector2& corner,
                                           const Vector2& opposite);

/// @throw Error when the rectangle reaches out of the map or none of its pixels holds data;
/// Canceled
[[nodiscard]] Roughness roughnessOf(const HeightRows& map, const PixelRectangle& pixels,
                                    Progress* progress = nullptr);

/// The surface at the pixel centers, NaN where the scan held no data; it must outlive the rows.
[[nodiscard]] HeightRows rowsOf(const BSplineSurface& surface);

}  // namespace asperity
