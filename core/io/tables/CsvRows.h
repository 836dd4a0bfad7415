#pragma once

#include "core/io/FileBytes.h"
#include "core/io/TextLines.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Splits a line of CSV into its cells, without the blanks around them; a cell in double quotes may
/// hold commas, and a doubled quote stands for one.
/// @param most  cells that are kept: those beyond are counted only
/// @param cells their room is used again
/// @return how many there are; 0: a quoted cell is not closed
std::size_t splitCells(std::string_view line, std::size_t most, std::vector<std::string>& cells);

/// Splits the line that names the columns of a table.
/// @param refuse (sentence) throws
/// @throw what `refuse` throws for a quoted cell that is not closed or for too many columns
template <class Refuse>
[[nodiscard]] std::vector<std::string> columnNamesOf(std::string_view line, const Refuse& refuse) {
    constexpr std::size_t kMostColumns = 10'000;
    std::vector<std::string> names;
    const std::size_t count = splitCells(line, kMostColumns, names);
    if (count == 0) {
        refuse("a quoted cell is not closed");
    }
    if (count > kMostColumns) {
        refuse("expected at most " + std::to_string(kMostColumns) + " columns, found " +
               std::to_string(count));
    }
    return names;
}

/// Splits a line into as many cells as there are columns.
/// @throw what `refuse` throws for a quoted cell that is not closed or another number of cells
template <class Refuse>
void splitRow(std::string_view line, std::size_t columns, std::vector<std::string>& cells,
              const Refuse& refuse) {
    const std::size_t count = splitCells(line, columns, cells);
    if (count == 0) {
        refuse("a quoted cell is not closed");
    }
    if (count != columns) {
        refuse("expected " + std::to_string(columns) + " cells as in the header, found " +
               std::to_string(count));
    }
}

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
    std::optional<std::string_view> nextLine();

    FileBytes bytes_;
    TextLines lines_;
    std::vector<std::string> comments_;
    std::vector<std::string> columns_;
    std::vector<std::string> cells_;
};

}  // namespace asperity
