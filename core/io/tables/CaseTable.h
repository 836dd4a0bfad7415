#pragma once

#include "core/Progress.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace asperity {

/// Columns and cells that are added to a table of cases.
struct CaseAnswers {
    std::vector<std::string> comments;  ///< above the table, one line each, without the `#`
    std::vector<std::string> columns;
    std::function<void(CsvWriter&, std::size_t)> add;  ///< the cells of these columns for one row
};

/// Reads a table of cases. @param required columns that it must have
/// @throw InputError when it cannot be read or a column is missing
[[nodiscard]] CsvTable readCases(const std::filesystem::path& file,
                                 const std::vector<std::string>& required);

/// Writes each row of the cases as it came in, the answers after it.
/// @throw InputError, before anything is written, when an added column is in the cases already;
///        Error when not all could be written; Canceled
void writeCases(std::ostream& out, const CsvTable& cases, const CaseAnswers& answers,
                Progress* progress = nullptr);

}  // namespace asperity
