#pragma once

#include "core/surface/BSplineSurface.h"

namespace asperity {

/// The surface through heights of another one, with at most this many pixels along each side: for
/// pictures that show no more. One that has no more comes back as it is. A pixel is filled where
/// the other surface is at its center.
[[nodiscard]] BSplineSurface coarserSurface(const BSplineSurface& surface, int mostPixels);

}  // namespace asperity
