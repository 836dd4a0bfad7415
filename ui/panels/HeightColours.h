#pragma once

#include "ui/ColourScale.h"

namespace asperity {

/// The colours of heights, dark to light: those of the 3-D views (vtkplugins/pictures/Palette.cxx;
/// a test holds the two together). Heights in metres.
[[nodiscard]] ColourScale heightColours(double low, double high);

/// The colour of a value; beyond the ends that of the nearer end. @param scale with colours
[[nodiscard]] QColor colourAt(const ColourScale& scale, double value);

}  // namespace asperity
