#pragma once

#include "core/SiFormat.h"

#include <QColor>
#include <QString>

#include <limits>
#include <vector>

namespace asperity {

class ColorTable;

/// Which colors stand for which values; what a color bar shows.
struct ColorScale {
    QString quantity;            ///< "height"
    QString unit;                ///< of the values; SI units are shown with the fitting prefix
    double low = 0.0;            ///< value of the first color, in `unit`
    double high = 0.0;           ///< value of the last one
    std::vector<QColor> colors;  ///< evenly spread; at least two, or none: nothing to show

    double dataLow = std::numeric_limits<double>::quiet_NaN();   ///< lowest value there is
    double dataHigh = std::numeric_limits<double>::quiet_NaN();  ///< highest value there is
    QString rule;  ///< how the range is chosen, "1–99 %"; empty: all values
    QString note;  ///< why there are no values: "no contact"; empty: there are

    [[nodiscard]] bool clipsLow() const { return dataLow < low; }
    [[nodiscard]] bool clipsHigh() const { return dataHigh > high; }
};

/// The scale of a table's colors.
[[nodiscard]] ColorScale scaleOf(const ColorTable& table, const QString& quantity,
                                 const QString& unit);

/// How values up to a magnitude are shown: SI units with the fitting prefix, angles in degrees,
/// units that have a prefix already, or are none of the SI, as they are; "1" without a unit.
[[nodiscard]] SiScale shownScale(double magnitude, const QString& unit);
/// A value for people, to `digits` digits: "12.3 nm", "45.0 °".
[[nodiscard]] QString shownValue(double value, const QString& unit, int digits = 3);

}  // namespace asperity
