#pragma once

#include "core/Vector.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewFrame.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkSmartPointer.h>

#include <array>

class vtkActor;
class vtkPolyData;

namespace asperity {

/// Direction of a view's light, as seen on the screen; it moves with the eye.
struct Light {
    double azimuth = 132.0;   ///< counterclockwise from rightwards [degree]
    double elevation = 24.0;  ///< above the screen's plane, to the eye [degree]

    /// Unit vector: rightwards, upwards, to the eye.
    [[nodiscard]] Vector3 direction() const;

    bool operator==(const Light&) const = default;
};

inline constexpr double kMaxHeightScale = 1000.0;

/// Options of a view that a user switches.
struct ViewOptions {
    double heightScale = 1.0;  ///< of all that is upright, 1 .. kMaxHeightScale
    bool axes = true;
    bool scaleBars = true;
    bool grid = false;
    bool labels = true;         ///< values, names and notes: without them pictures are exported
    bool deformation = true;    ///< the surface moves under the tip; else it is drawn at rest
    bool section = false;       ///< the half before the tip is cut away
    bool commandedTip = false;  ///< ghost of the tip where it would be without forces
    bool trueTip = false;       ///< ghost of the tip where a simulated instrument has it
    Light light;

    bool operator==(const ViewOptions&) const = default;
};

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

    /// The same of a polished round body, whose highlight runs along its axis, and of its far wall
    /// where that is seen through the near one.
    [[nodiscard]] std::array<unsigned char, 3> polished(const Color& color,
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
