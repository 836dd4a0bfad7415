#pragma once

#include "core/Progress.h"

#include <filesystem>
#include <ostream>

namespace asperity {

/// Forces for every row of a table of signals (CSV), written as a table that repeats the row and
/// adds force, covariance, condition and case. All vectors and the covariance are in the lab frame;
/// a row that is no measurement has the case "invalid_input" and nan for its numbers. Nothing is
/// written unless the whole table can be read.
/// @param probe a probe file, see readProbe()
/// @throw InputError for a missing column, a cell that is no number, or volts without a
/// calibration;
///        Canceled
void writeForceEstimates(const std::filesystem::path& probe, const std::filesystem::path& cases,
                         std::ostream& out, Progress* progress = nullptr);

}  // namespace asperity
