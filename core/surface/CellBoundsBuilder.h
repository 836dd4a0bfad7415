#pragma once

#include "core/Progress.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/CellBounds.h"

namespace asperity {

/// Bounds of every cell of the height field that a usable grid defines, from the Bezier points of
/// each cell. Linear time.
/// @throw Canceled
[[nodiscard]] CellBounds cellBoundsOf(const BSplineSurface::Grid& grid,
                                      Progress* progress = nullptr);

}  // namespace asperity
