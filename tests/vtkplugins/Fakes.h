#pragma once

#include "core/Units.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "vtkplugins/pictures/DeformationPicture.h"

namespace asperity::test {

/// Surface whose control heights are height(x, y) at the pixel centers.
template <typename Height>
[[nodiscard]] BSplineSurface splineOf(int pixels, double pitch, const Height& height) {
    BSplineSurface::Grid grid{.columns = pixels,
                              .rows = pixels,
                              .pitchX = pitch,
                              .pitchY = pitch,
                              .controlHeights = {},
                              .invalid = {}};
    for (int row = -1; row <= pixels; ++row) {
        for (int column = -1; column <= pixels; ++column) {
            grid.controlHeights.push_back(
                static_cast<float>(height((column + 0.5) * pitch, (row + 0.5) * pitch)));
        }
    }
    return BSplineSurface(std::move(grid));
}

/// A 1 µm scan of 20 nm hills and hollows.
[[nodiscard]] BSplineSurface eggBox();

/// A flat sample under a sphere of 15 nm that presses a circle of 3 nm (Hertz).
[[nodiscard]] DeformationView hertzDent();

/// The same sample pulled up into a neck by adhesion just before it lets go (JKR).
[[nodiscard]] DeformationView adhesionNeck();

}  // namespace asperity::test
