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
};

using ShownNumbers = std::vector<ShownNumber>;

/// As tab-separated text: a line of headers, then name, value, standard deviation and unit of each.
[[nodiscard]] QString tabSeparated(const ShownNumbers& numbers);

}  // namespace asperity
