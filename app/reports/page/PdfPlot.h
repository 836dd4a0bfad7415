#pragma once

#include "app/reports/page/PlotDrawing.h"

#include <QPainter>

namespace asperity {

/// Draws a plot as vectors. The painter's unit is a point, its origin the plot's upper left corner.
void paintPlot(QPainter& painter, const PlotDrawing& drawing);

}  // namespace asperity
