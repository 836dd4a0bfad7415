#pragma once

#include "ui/ColorScale.h"

namespace asperity {

/// The colors of heights, dark to light: those of the 3-D views (vtkplugins/pictures/Palette.cxx;
/// a test holds the two together). Heights in meters.
[[nodiscard]] ColorScale heightColors(double low, double high);

/// The color of a value; beyond the ends that of the nearer end. @param scale with colors
[[nodiscard]] QColor colorAt(const ColorScale& scale, double value);

}  // namespace asperity
