#pragma once

#include "core/io/tables/CsvTable.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace asperity {

/// The tables of a recording as text.
struct TextTables {
    std::filesystem::path input;   ///< tick_input.csv
    std::filesystem::path log;     ///< force_log.csv
    std::filesystem::path energy;  ///< energy_log.csv; empty: there is none
};

/// Writes the tables of a recording into one HDF5 file of about a tenth of their size: the groups
/// tick_input, force_log and energy_log, a dataset a column with its unit as an attribute. Inputs
/// and energies keep all their digits; of the log, which replays from the inputs, times and what is
/// also an input do, and the rest is in single precision, with checks of all of its digits.
/// docs/recordings.md
/// @throw Error when it cannot be written; InputError as CsvRows
void packTables(const TextTables& tables, const std::filesystem::path& packed);

/// A force log with fewer digits than it had.
struct PackedLog {
    CsvTable rows;
    std::vector<std::uint32_t> checks;  ///< of its rows with all digits: RowChecks
};

/// @throw InputError
[[nodiscard]] CsvTable readPackedInput(const std::filesystem::path& packed);
/// @throw InputError
[[nodiscard]] PackedLog readPackedLog(const std::filesystem::path& packed);
/// Writes the inputs, and the energies where there are, as text again. @throw InputError, Error
void unpackTables(const std::filesystem::path& packed, const TextTables& tables);

}  // namespace asperity
