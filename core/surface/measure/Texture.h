#pragma once

#include "core/Progress.h"
#include "core/surface/HeightMap.h"

#include <optional>

namespace asperity {

/// Spatial parameters of ISO 25178-2, of the normalized autocorrelation of the heights and the
/// central lobe of lags in which it is above 0.2.
struct Texture {
    /// Autocorrelation length, the shortest distance from no lag to the edge of the lobe [m]. Empty
    /// where the lobe has no edge within half of the sides, or all heights are the same.
    std::optional<double> sal;
    /// Texture aspect ratio, Sal over the longest such distance, 0..1. Empty where the lobe goes
    /// on beyond half of a side.
    std::optional<double> str;
    int step = 1;  ///< every how manieth pixel of a row and of a column was used
};

/// The texture of a rectangle. Heights are about the mean of the pixels with data. They are not
/// repeated beyond the rectangle: each lag is a mean over the pairs of pixels with data that lie
/// that far apart. Of more than 2048 pixels a side only every step-th is used.
/// @throw Error when the rectangle reaches out of the map or none of its pixels holds data;
/// Canceled
[[nodiscard]] Texture textureOf(const HeightRows& map, const PixelRectangle& pixels,
                                Progress* progress = nullptr);

}  // namespace asperity
