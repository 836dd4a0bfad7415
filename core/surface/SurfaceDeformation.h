#pragma once

#include "core/Vector.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// A piece of the surface around the contact, sampled finely: where it lies at rest and where the
/// tip has moved it. Grids are row-major, bottom row (smallest y) first; world frame [m].
struct SurfacePatch {
    int columns = 0;
    int rows = 0;
    std::vector<Vector3> rest;     ///< undeformed surface points
    std::vector<Vector3> points;   ///< deformed surface points
    std::vector<Vector3> normals;  ///< of the deformed surface, unit, out of the sample

    [[nodiscard]] std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

}  // namespace asperity
