#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Quantity in a column of a force-distance curve.
enum class CurveQuantity : std::uint8_t {
    Other,
    Base,         ///< of the lever, either sign
    Separation,   ///< growing away from the sample
    Indentation,  ///< growing into it
    Deflection,
    Force,
    Voltage,  ///< a signal that is not calibrated
    Time,
    Segment,  ///< names the branch
};

/// One column as its title says.
struct CurveColumn {
    CurveQuantity quantity = CurveQuantity::Other;
    double factor = 1.0;   ///< to the SI unit
    int rank = 0;          ///< of several with the same quantity, the highest is meant
    bool retract = false;  ///< the title says that it belongs to the retract
};

/// "Extend Z-Sense(nm)", "Force [nN]", "base_m".
[[nodiscard]] CurveColumn curveColumn(std::string_view title);

/// A column of a text table as the user names it.
struct GivenColumn {
    int number = 0;  ///< of the column, the first is 1
    CurveColumn column;
};

/// Reads "base=1:um,deflection=2:nm,time=3:ms": the quantity, the number of its column, and its
/// unit, which is that of SI where none is given. "retract-" before a quantity: the column belongs
/// to the retract alone.
/// @throw Error with what was expected
[[nodiscard]] std::vector<GivenColumn> givenColumns(std::string_view text);

/// The cells of a line. Parted by tabs, else by semicolons, else by commas; quotes are taken off.
[[nodiscard]] std::vector<std::string> curveCells(std::string_view line);

/// The cells of a row that holds numbers alone. The same, or parted by blanks; empty: no way of
/// parting it makes each of these columns, from 1 on, a number.
[[nodiscard]] std::vector<std::string> curveCells(std::string_view line,
                                                  const std::vector<int>& columns);

/// A cell as a number, with a decimal point or a decimal comma; NaN where the cell is empty,
/// nothing where it is anything else.
[[nodiscard]] std::optional<double> cellNumber(std::string_view cell);

}  // namespace asperity
