#pragma once

#include "core/surface/nurbs/NurbsSurface.h"

#include <vector>

namespace asperity {

/// A surface cut at its knots into rational Bezier patches.
struct NurbsDecomposition {
    std::vector<double> breaksU;  ///< from 0 to 1
    std::vector<double> breaksV;
    std::vector<NurbsPatch> patches;  ///< those along u next to each other
};

/// @throw Error as NurbsSurface()
[[nodiscard]] NurbsDecomposition decomposed(const NurbsSurface::Net& net);

/// A tree over the boxes of the patches, children before parents.
[[nodiscard]] std::vector<PatchBox> boxTree(const std::vector<NurbsPatch>& patches);

}  // namespace asperity
