#pragma once

#include "core/Vector.h"
#include "vtkplugins/pictures/Palette.h"

#include <vtkSmartPointer.h>

#include <span>
#include <vector>

class vtkActor;
class vtkLookupTable;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

/// Columns and rows of a grid of points.
struct GridSize {
    int columns = 0;
    int rows = 0;
};

/// Response of a matt surface to light.
struct Matt {
    double ambient = 0.0;
    double diffuse = 0.0;
};

inline constexpr Matt kPlainMatt{0.36, 0.66};
inline constexpr Matt kWallMatt{0.8, 0.25};  ///< of blockWalls()

/// A surface colored by its scalars.
[[nodiscard]] vtkSmartPointer<vtkActor> coloredSurface(vtkPolyData* data, vtkLookupTable* table);
/// A surface of one color.
[[nodiscard]] vtkSmartPointer<vtkActor> plainSurface(vtkPolyData* data, const Color& color);
/// Walls from the border of a grid surface straight down to z = bottom: a solid block.
[[nodiscard]] vtkSmartPointer<vtkActor> blockWalls(vtkPolyData* surface, GridSize size,
                                                   double bottom);
/// Sides of a block that have walls.
struct BlockWalls {
    bool front = true;  ///< smallest y
    bool back = true;
    bool left = true;  ///< smallest x
    bool right = true;
};

/// Returns the points of the walls: pairs, one of the surface and one below it.
[[nodiscard]] vtkSmartPointer<vtkPolyData> blockSides(vtkPolyData* surface, GridSize size,
                                                      double bottom, const BlockWalls& walls = {});
/// The same as walls look: matt, of the color of a block's sides.
[[nodiscard]] vtkSmartPointer<vtkActor> wallSurface(vtkPolyData* data);
/// Lines of one color that win against the surface they lie on; width in pixels of the picture.
[[nodiscard]] vtkSmartPointer<vtkActor> lines(vtkPolyData* data, const Color& color, double width);
/// The same; width in pixels as they are drawn.
[[nodiscard]] vtkSmartPointer<vtkActor> linesAsDrawn(vtkPolyData* data, const Color& color,
                                                     double width);

/// One line through the points.
[[nodiscard]] vtkSmartPointer<vtkPolyData> polyline(const std::vector<Vector3>& points);
/// About `count` lines each way along the points of a grid surface, its border among them.
[[nodiscard]] vtkSmartPointer<vtkPolyData> drapedGrid(vtkPolyData* surface, GridSize size,
                                                      int count);
/// Lights from the upper left and a weak one from the camera.
void addLights(vtkRenderer* renderer);
/// Returns the brightness of a matt surface under such lights, about 0 ... 1, for colors that are
/// lit before they are drawn. Unit vectors: rightwards, upwards and to the eye.
/// @param toLight to the strong one
[[nodiscard]] double brightness(const Vector3& normal, const Vector3& toLight, const Matt& matt);

/// Sets for all views one camera without perspective, `direction` pointing from the scene to the
/// eye, such that all their actors fill a view whose sides have the ratio `aspect` (width /
/// height).
void fitCamera(std::span<vtkRenderer* const> views, const Vector3& direction, double aspect);

/// The space that a picture draws: the world, with all heights multiplied by one factor. Surface,
/// tip and contact share it, so that what touches in the world touches in the picture.
class Stretch {
public:
    /// @param factor 1: true to scale
    explicit Stretch(double factor) : factor_(factor) {}

    [[nodiscard]] double factor() const { return factor_; }
    [[nodiscard]] Vector3 point(const Vector3& world) const {
        return {world.x(), world.y(), factor_ * world.z()};
    }
    /// Unit normal of what is drawn, of the unit normal of a surface in the world.
    [[nodiscard]] Vector3 normal(const Vector3& world) const {
        return Vector3(world.x(), world.y(), world.z() / factor_).normalized();
    }
    /// A copy with stretched points and, where there are any, normals.
    [[nodiscard]] vtkSmartPointer<vtkPolyData> apply(vtkPolyData* data) const;

private:
    double factor_;
};

/// An upright plane that opens a block to the eye: what lies in front of it is not drawn.
struct CutPlane {
    Vector3 origin = Vector3::Zero();     ///< on the plane
    Vector3 toFront = -Vector3::UnitY();  ///< level, unit, out of what is left
};

/// Returns what lies behind the plane, with its point data.
[[nodiscard]] vtkSmartPointer<vtkPolyData> behind(vtkPolyData* data, const CutPlane& plane);

/// Returns the line in which the plane meets a surface; empty where it does not.
[[nodiscard]] vtkSmartPointer<vtkPolyData> cutLine(vtkPolyData* surface, const CutPlane& plane);

/// Returns the face that the plane opens below such a line, straight down to z = bottom.
[[nodiscard]] vtkSmartPointer<vtkPolyData> cutFace(vtkPolyData* line, const CutPlane& plane,
                                                   double bottom);

}  // namespace asperity
