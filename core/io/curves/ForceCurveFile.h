#pragma once

#include "core/curves/AlignedForceCurve.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Reads a force-distance curve from a text: a table below a line that names a distance and a force
/// with their units, such as "Z (nm), Force (nN)", "base_m,force_N", "Time (s) Load (uN) ... Piezo
/// (nm)" or, with a pair of columns for each branch, "Extend Z-Sense(nm),Extend Force(nN),Retract
/// ...". Cells are parted by tabs, semicolons or commas; in the first two cases the decimal
/// separator may be a comma. Text above that line is left out, but for the spring constant.
///
/// Whatever its sign in the file, the base grows towards the sample, which is where the force is
/// largest. A column `segment` or `branch` parts the segments; without it the curve turns at its
/// largest force.
/// Source: docs/measuring.md, docs/formats.md.
/// @throw InputError where it is no such text, with what is missing: the signal is in volts, no
///        line names both columns, a cell is no number, ...
[[nodiscard]] MeasuredForceCurve readForceCurve(const std::filesystem::path& path);

/// Quantity in a column of a force-distance curve.
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
