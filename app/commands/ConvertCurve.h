#pragma once

#include "app/commands/ConvertMap.h"

#include <string>

namespace asperity {

/// Returns whether a file of this name is the table of a force curve.
[[nodiscard]] bool isCurveTable(const std::string& file);

/// Refuses options that are about height maps. @throw CLI::ValidationError
void requireCurveOptions(const ConvertOptions& options);

/// Writes one curve of a file as a table of all its samples: segment, time, base, deflection and
/// force, in SI units; a signal in volts where it has neither of the last two.
/// @throw Error; InputError
[[nodiscard]] Converted convertCurve(const ConvertOptions& options, const ConvertedFile& file);

}  // namespace asperity
