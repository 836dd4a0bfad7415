#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

namespace asperity {

/// The bicubic B-spline surface that passes through every pixel centre of the map.
///
/// At a border the first span is a quadratic, so quadratics come back exactly; the error inside the
/// scan falls with the fourth power of the pitch. Pixels whose height is not a number are filled
/// first (see withInvalidPixelsFilled()); the map's mask is kept, so isMeasured() tells them.
/// Linear time. Solved in double precision; the stored control heights then lie within 2^-25 of
/// their range (see BSplineSurface).
/// @throw Error when the map is unusable, holds no height at all, or its heights lie so far apart
///        that single precision cannot hold them
[[nodiscard]] BSplineSurface fitSurface(const HeightMap& map);

}  // namespace asperity
