#pragma once

#include "core/scene/SceneDescription.h"
#include "core/surface/HeightMap.h"
#include "core/surface/nurbs/NurbsSurface.h"

namespace asperity {

/// The surface that a shape is, without error; world frame, its window from the origin on.
/// A sphere and a cylinder (along y) touch z = 0 from above in the middle of the window; a plane
/// rises along x and has mean height 0. There is no other surface below them.
/// @throw Error as checkShape()
[[nodiscard]] NurbsSurface shapeSurface(const ShapeDescription& shape);

/// Its upper side in the window as a map of heights: what is drawn and where runs start.
/// @throw Error as checkShape()
[[nodiscard]] HeightMap shapeMap(const ShapeDescription& shape);

}  // namespace asperity
