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

/// How a matt surface answers to light.
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
/// Which sides of a block have walls.
struct BlockWalls {
    bool front = true;  ///< smallest y
    bool back = true;
    bool left = true;  ///< smallest x
    bool right = true;
};

/// What they are made of: pairs of points, one of the surface and one below it.
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
/// How bright a matt surface is under such lights, about 0 ... 1, for colors that are lit before
/// they are drawn. Unit vectors: rightwards, upwards and to the eye.
/// @param toLight to the strong one
[[nodiscard]] double brightness(const Vector3& normal, const Vector3& toLight, const Matt& matt);

/// Sets for all views one camera without perspective, `direction` pointing from the scene to the
/// eye, such that all their actors fill a view whose sides have the ratio `aspect` (width /
/// height).
void fitCamera(std::span<vtkRenderer* const> views, const Vector3& direction, double aspect);

}  // namespace asperity
