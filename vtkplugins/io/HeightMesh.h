#pragma once

#include "core/surface/HeightRows.h"

#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace asperity {

/// Of a mesh without any. The files' writers name no path: their callers do.
inline constexpr const char* kNoTriangles =
    "the map has no 2 x 2 valid pixels to make a surface of";

/// @throw Error
void requireWritten(bool isWritten);

/// Heights from the bottom row up, as VTK numbers points; NaN where there are no data.
/// @throw Canceled
[[nodiscard]] vtkSmartPointer<vtkDoubleArray> heightArray(const HeightRows& map,
                                                          Progress* progress);

/// The pixel centers in the world frame of the whole map, in the order of `heights`; at height 0
/// where there are no data. @param rowsBelow as of meshOf()
[[nodiscard]] vtkSmartPointer<vtkPoints> pointsOf(const HeightRows& map, vtkDoubleArray* heights,
                                                  int rowsBelow);

/// Two triangles, counter-clockwise from above, for each four pixels that all have a height, in the
/// world frame of the whole map; of `map`, which may be a strip of it, the heights.
/// @param rowsBelow rows of the whole map below this strip @throw Canceled
[[nodiscard]] vtkSmartPointer<vtkPolyData> meshOf(const HeightRows& map, vtkDoubleArray* heights,
                                                  int rowsBelow, Progress* progress);

}  // namespace asperity
