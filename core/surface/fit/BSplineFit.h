#pragma once

#include "core/Progress.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"
#include "core/surface/fit/GaussianFilter.h"

namespace asperity {

/// The bicubic B-spline surface of the map after a Gaussian low-pass; without one it passes through
/// every pixel center.
///
/// A plane comes back unchanged whatever the smoothing. Without smoothing quadratics do, because
/// the first span at a border is a quadratic; the error inside the scan falls with the fourth power
/// of the pitch. What smoothing and spline do near the borders: see lineFitWeights().
/// Pixels whose height is not a number are filled first (see withInvalidPixelsFilled()); the map's
/// mask is kept, so isMeasured() knows them. Linear time, two threads.
///
/// A ScanMap is computed in single precision about its datum: a control height is off by a few
/// times, at most 16 times, 2^-24 of the largest distance of a height from the datum, and a second
/// derivative by four times that over the pitch squared.
/// @throw Error when the map is unusable, holds no height at all, or a width is not in
///        0..kMaxSmoothing; Canceled
[[nodiscard]] BSplineSurface fitSurface(ScanMap map, const Smoothing& smoothing = {},
                                        Progress* progress = nullptr);

/// The same in double precision, for maps that are not too large for it. Control heights are kept
/// to 2^-48 where single precision would put second derivatives off by more than 1e3 1/m.
[[nodiscard]] BSplineSurface fitSurface(HeightMap map, const Smoothing& smoothing = {},
                                        Progress* progress = nullptr);

/// The surface through heights of another one, with at most this many pixels along each side: for
/// pictures that show no more. One that has no more comes back as it is. A pixel is filled where
/// the other surface is at its center.
[[nodiscard]] BSplineSurface coarserSurface(const BSplineSurface& surface, int mostPixels);

/// Returns what smoothing took from a scan: data minus surface at every pixel center [m]. Pixels
/// without data have no residual either: they keep their mark and are not a number.
/// @param surface fitted to this map
/// @throw Error when the map is unusable or the surface has another size
[[nodiscard]] HeightMap residualOf(HeightMap map, const BSplineSurface& surface);
[[nodiscard]] ScanMap residualOf(ScanMap map, const BSplineSurface& surface);

}  // namespace asperity
