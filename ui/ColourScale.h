#pragma once

#include <QColor>
#include <QString>

#include <vector>

namespace asperity {

/// Which colours stand for which values; what a colour bar shows.
struct ColourScale {
    QString quantity;             ///< "height"
    QString unit;                 ///< SI unit of the values, shown with the fitting prefix
    double low = 0.0;             ///< value of the first colour, in `unit`
    double high = 0.0;            ///< value of the last one
    std::vector<QColor> colours;  ///< evenly spread; at least two, or none: nothing to show
};

}  // namespace asperity
