#pragma once

#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"
#include "core/scene/Settings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// Names of the columns that hold Settings, in the order in which addSettings() writes them.
[[nodiscard]] std::vector<std::string> settingsColumns();

/// The next cells of the row, to the last bit.
void addSettings(CsvWriter& csv, const Settings& settings);

/// The settings of a row. Recordings from before there was a knob say nothing of it: it has its
/// default then, which does what the program did before. @throw InputError with line and column
[[nodiscard]] Settings readSettings(const CsvTable& table, std::size_t row);

}  // namespace asperity
