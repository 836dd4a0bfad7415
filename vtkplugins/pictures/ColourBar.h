#pragma once

#include "vtkplugins/pictures/Painter.h"

#include <string>

class vtkLookupTable;

namespace asperity {

/// What a colour bar says.
struct ColourBar {
    std::string quantity;  ///< "height"
    std::string unit;      ///< SI unit of the values; shown with the fitting prefix
    double low = 0.0;      ///< shown range, in `unit`
    double high = 1.0;
    vtkLookupTable* table = nullptr;  ///< colours of the values
};

/// Draws the bar along `area`, low values left, its name before it and its labels below it.
void drawColourBar(Painter& painter, const ColourBar& bar, const PixelRect& area);

}  // namespace asperity
