#pragma once

#include "core/Progress.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity {

/// Areal parameters of ISO 25178-2 over the pixels that hold data, each standing for its area. The
/// reference is their mean height: form is removed before, by leveling.
struct Roughness {
    double sa = 0.0;  ///< arithmetical mean height, mean of |z - mean| [m]
    double sq = 0.0;  ///< root mean square height, root of the mean of (z - mean)^2 [m]
    double sz = 0.0;  ///< maximum height, highest - lowest [m]
    double sp = 0.0;  ///< maximum peak height, highest - mean [m]
    double sv = 0.0;  ///< maximum pit height, mean - lowest [m]
    /// Skewness and kurtosis, means of (z - mean)^3 / Sq^3 and (z - mean)^4 / Sq^4. Empty where all
    /// heights are the same: they would be 0 / 0, and each number in their stead a wrong one.
    std::optional<double> ssk;
    std::optional<double> sku;
    double sdq = 0.0;      ///< root mean square gradient
    double sdr = 0.0;      ///< developed interfacial area ratio, surface over its outline - 1
    double mean = 0.0;     ///< [m]
    double lowest = 0.0;   ///< [m]
    double highest = 0.0;  ///< [m]
    std::size_t pixels = 0;
    /// Squares of 2 x 2 such pixels, of which Sdq and Sdr are: gradient and surface of a square are
    /// means over both ways to split it into two triangles. Without one both are 0.
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

/// Number of heights by height, in bins of one width from the lowest height to the highest.
struct HeightHistogram {
    double lowest = 0.0;              ///< lower edge of the first bin [m]
    double width = 0.0;               ///< of a bin; 0: all heights are the same [m]
    std::vector<std::size_t> counts;  ///< of pixels with data

    [[nodiscard]] double middle(std::size_t bin) const {  ///< [m]
        return lowest + (static_cast<double>(bin) + 0.5) * width;
    }
};

/// @param roughness of the same pixels @throw Canceled
[[nodiscard]] HeightHistogram histogramOf(const HeightRows& map, const PixelRectangle& pixels,
                                          const Roughness& roughness, Progress* progress = nullptr);

/// The surface at the pixel centers, NaN where the scan held no data; it must outlive the rows.
[[nodiscard]] HeightRows rowsOf(const BSplineSurface& surface);

}  // namespace asperity
