#pragma once

#include "core/Vector.h"
#include "ui/view/ViewCamera.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkSmartPointer.h>

#include <array>

class vtkActor;
class vtkPolyData;

namespace asperity {

/// Lights the colors of a surface before they are drawn: on a computer without a graphics card,
/// a light costs more for every pixel than for every point of the surface.
class Shading {
public:
    explicit Shading(const ViewCamera& camera);

    /// `color` as it looks where the surface has this unit normal, world frame.
    [[nodiscard]] std::array<unsigned char, 3> lit(const Color& color, const Vector3& normal,
                                                   const Matt& matt = kPlainMatt) const;

private:
    Matrix3 toView_;  ///< rightwards, upwards, to the eye
};

/// A surface that shows its points' RGB or RGBA scalars as they are.
[[nodiscard]] vtkSmartPointer<vtkActor> surfaceAsColored(vtkPolyData* data);

}  // namespace asperity
