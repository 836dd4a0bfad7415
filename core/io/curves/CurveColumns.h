#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// What a column of a force-distance curve holds.
enum class CurveQuantity : std::uint8_t {
    Other,
    Base,         ///< of the lever, either sign
    Separation,   ///< growing away from the sample
    Indentation,  ///< growing into it
    Deflection,
    Force,
    Voltage,  ///< a signal that is not calibrated
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

/// The cells of a line. Parted by tabs, else by semicolons, else by commas; quotes are taken off.
[[nodiscard]] std::vector<std::string> curveCells(std::string_view line);

}  // namespace asperity
