#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

#include <array>

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

}  // namespace asperity
