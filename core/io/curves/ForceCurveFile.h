#pragma once

#include "core/curves/MeasuredForceCurve.h"

#include <filesystem>

namespace asperity {

/// Reads a force-distance curve from a text: a table below a line that names a distance and a force
/// with their units, such as "Z (nm), Force (nN)", "base_m,force_N", "Time (s) Load (uN) ... Piezo
/// (nm)" or, with a pair of columns for each branch, "Extend Z-Sense(nm),Extend Force(nN),Retract
/// ...". Cells are parted by tabs, semicolons or commas; in the first two cases the decimal
/// separator may be a comma. What stands above that line is left out, but for the spring constant.
///
/// Whatever its sign in the file, the base grows towards the sample, which is where the force is
/// largest. A column `segment` or `branch` parts the segments; without it the curve turns at its
/// largest force.
/// Source: docs/measuring.md, docs/formats.md.
/// @throw InputError where it is no such text, with what is missing: the signal is in volts, no
///        line names both columns, a cell is no number, ...
[[nodiscard]] MeasuredForceCurve readForceCurve(const std::filesystem::path& path);

}  // namespace asperity
