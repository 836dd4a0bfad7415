#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

#include <array>

namespace asperity {

// For other programs; Asperity does not read them. Coordinates are those of the world frame [m].
// .vti and .vtp need VTK's whole data set in memory, .stl a few rows.

/// An image of point values "height" [m] at the pixel centers, bottom row first; values without a
/// unit have the name of the map's title. Pixels that hold no data are 0 in the array "valid",
/// which is there when any is.
extern const HeightMapFormat kVtiFormat;
/// Triangles through the pixel centers with "height" [m]; none touches an invalid pixel. Throws
/// Error when no triangle is left, as the next one.
extern const HeightMapFormat kVtpFormat;
/// The same triangles, binary. STL knows no unit: coordinates are METERS, and the file's header
/// says so.
extern const HeightMapFormat kStlFormat;

inline constexpr std::array kVtkFormats{&kVtiFormat, &kVtpFormat, &kStlFormat};

}  // namespace asperity
