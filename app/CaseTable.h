#pragma once

#include "core/io/CsvTable.h"
#include "core/io/CsvWriter.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace asperity {

/// Where a command that works through a table of cases reads and writes.
struct CaseFiles {
    std::string cases;
    std::string out;  ///< empty: standard output
};

/// The options --cases and --out.
void addCaseFiles(CLI::App& command, CaseFiles& files);

/// A table of cases on its way through: each row goes out as it came in, with new columns after it.
class CaseTable {
public:
    /// @param required columns that the cases must have  @param added columns
    /// @throw InputError when the cases cannot be read or a column is missing; Error when there is
    ///        no writing where the result shall go
    CaseTable(const CaseFiles& files, const std::vector<std::string>& comments,
              const std::vector<std::string>& required, const std::vector<std::string>& added);

    [[nodiscard]] const CsvTable& cases() const noexcept { return cases_; }
    /// Begins the next row with the cells of the case; the added ones follow by result().
    void beginRow(std::size_t row);
    [[nodiscard]] CsvWriter& result() noexcept { return writer_; }
    /// @throw Error when not all could be written
    void close() { writer_.close(); }

private:
    CsvTable cases_;
    CsvWriter writer_;
};

}  // namespace asperity
