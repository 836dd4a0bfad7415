#pragma once

#include "core/haptics/HandPath.h"

#include <QPolygonF>

#include <string>

namespace asperity {

/// A path in other units than metres would lead the tip far away, and take as long.
/// @throw InputError when the path leaves the scan by more than its width
void requireNear(const Scene& scene, const HandPath& path, const std::string& file);

/// A path from above, thin enough to draw [m].
[[nodiscard]] QPolygonF outline(const HandPath& path);

}  // namespace asperity
