#pragma once

#include <QColor>
#include <QString>

#include <vector>

namespace asperity {

/// Which colors stand for which values; what a color bar shows.
struct ColorScale {
    QString quantity;            ///< "height"
    QString unit;                ///< SI unit of the values, shown with the fitting prefix
    double low = 0.0;            ///< value of the first color, in `unit`
    double high = 0.0;           ///< value of the last one
    std::vector<QColor> colors;  ///< evenly spread; at least two, or none: nothing to show
};

}  // namespace asperity
