#pragma once

#include "core/io/FileBytes.h"
#include "core/io/TextLines.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The cells of a line of CSV, without the blanks around them; a cell in double quotes may hold
/// commas, and a doubled quote stands for one. @return empty: a quoted cell is not closed
[[nodiscard]] std::vector<std::string> csvCells(std::string_view line);

/// The rows of a CSV table, one after the other: for a table that is too large to be read whole.
class CsvRows {
public:
    /// @throw InputError when it cannot be read or has no line that names the columns
    explicit CsvRows(const std::filesystem::path& path);

    [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
    /// Of the lines above the columns' names that start with `#`, without it.
    [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }

    /// @return false: there are no more rows. @throw InputError for a row with another number of
    /// cells than there are columns
    [[nodiscard]] bool next();
    /// Of the present row.
    [[nodiscard]] const std::vector<std::string>& cells() const { return cells_; }

private:
    bool nextCells(std::vector<std::string>& cells);

    FileBytes bytes_;
    TextLines lines_;
    std::vector<std::string> comments_;
    std::vector<std::string> columns_;
    std::vector<std::string> cells_;
};

}  // namespace asperity
