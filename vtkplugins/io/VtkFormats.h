#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/HeightMap.h"
#include "core/surface/deformation/SurfaceDeformation.h"

#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>

namespace asperity {

// Shapes for other programs; Asperity does not read them. Coordinates are those of the world frame
// [m]. .vtp and .vts need VTK's whole data set in memory, .stl a few rows.

/// Triangles through the pixel centers with "height" [m]; none touches an invalid pixel. Throws
/// Error when no triangle is left, as kStlFormat does.
extern const HeightMapFormat kVtpFormat;
/// A grid of points at the pixel centers with "height" [m], bottom row first; those without data
/// are blanked, at height 0.
extern const HeightMapFormat kVtsFormat;
/// The triangles of kVtpFormat, binary. STL knows no unit: coordinates are METERS, and the file's
/// header says so.
extern const HeightMapFormat kStlFormat;

inline constexpr std::array kVtkFormats{&kVtpFormat, &kVtsFormat, &kStlFormat};

/// Writes the triangles of a height map [m] as binary STL, a few rows of pixels at a time: VTK
/// wants the mesh that it writes in memory, and the mesh of a large scan is 20 times the scan.
/// @param target the caller puts it in place afterwards
/// @throw Error when no triangle is left, or the file cannot be written; Canceled
void writeStl(const std::filesystem::path& target, const HeightRows& map, Progress* progress);

/// Message on a mesh without triangles. The files' writers name no path: their callers do.
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

// A deformed patch for other programs: points of the deformed surface in the world frame [m], with
// "rest" (the same points of the undeformed surface), "displacement" and "normal" as doubles.

/// As triangles, .vtp. Whole or not at all. @throw Error
void writePatchVtp(const std::filesystem::path& path, const SurfacePatch& patch);
/// As a grid, bottom row first, .vts. Whole or not at all. @throw Error
void writePatchVts(const std::filesystem::path& path, const SurfacePatch& patch);

}  // namespace asperity
