#pragma once

#include "vtkplugins/pictures/Painter.h"

#include <string>

class vtkLookupTable;

namespace asperity {

/// What a color bar says.
struct ColorBar {
    std::string quantity;  ///< "height"
    std::string unit;      ///< SI unit of the values, shown with the fitting prefix; empty: numbers
    double low = 0.0;      ///< shown range, in `unit`
    double high = 1.0;
    vtkLookupTable* table = nullptr;  ///< colors of the values
};

/// Draws the bar along `area`, low values left, its name before it and its labels below it.
void drawColorBar(Painter& painter, const ColorBar& bar, const PixelRect& area);

}  // namespace asperity
