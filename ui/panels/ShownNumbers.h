#pragma once

#include <QString>

#include <optional>
#include <vector>

namespace asperity {

/// A number that the window shows.
struct ShownNumber {
    QString name;
    double value = 0.0;           ///< in `unit`; not finite: nothing is known
    std::optional<double> sigma;  ///< its standard deviation, where one is known
    QString unit;                 ///< SI; empty: a count
    /// What model and calibration leave open in it, a standard deviation, where that is known.
    std::optional<double> modelSigma = {};
};

using ShownNumbers = std::vector<ShownNumber>;

/// As tab-separated text: a line of headers, then name, value, standard deviations by noise and by
/// model, and unit of each.
[[nodiscard]] QString tabSeparated(const ShownNumbers& numbers);

}  // namespace asperity
