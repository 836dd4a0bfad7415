#pragma once

#include "core/Vector.h"
#include "ui/view/DrawnSpace.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewOptions.h"
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
    Shading(const ViewCamera& camera, const DrawnSpace& space, const Light& light);

    /// `color` as it looks where a face has this unit normal, world frame. From below the sample,
    /// a face is lit on the side that is seen: the block of sample is open there.
    [[nodiscard]] std::array<unsigned char, 3> lit(const Color& color, const Vector3& normal,
                                                   const Matt& matt = kPlainMatt) const;

    /// The same of the sample's surface. Its underside has the color of the block's walls: colors
    /// stand for what the tip sees.
    [[nodiscard]] std::array<unsigned char, 3> litSurface(const Color& color,
                                                          const Vector3& normal) const;

private:
    [[nodiscard]] bool isUnderside(const Vector3& seenNormal) const;

    DrawnSpace space_;
    Matrix3 toView_;  ///< rightwards, upwards, to the eye
    Vector3 toLight_;
};

/// Gives the points of `data`, which have normals in the world frame, the color of a surface there.
void paint(vtkPolyData* data, const Color& color, const Shading& shading,
           const Matt& matt = kPlainMatt);

/// A surface that shows its points' RGB or RGBA scalars as they are.
[[nodiscard]] vtkSmartPointer<vtkActor> surfaceAsColored(vtkPolyData* data);

}  // namespace asperity
