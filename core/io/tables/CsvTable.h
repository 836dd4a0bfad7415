#pragma once

#include "core/io/FileBytes.h"
#include "core/io/FormerKeys.h"
#include "core/io/TextLines.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

/// A CSV table with named columns of numbers or text. Lines that start with `#` and empty lines are
/// skipped; the first other line names the columns, see columnNamesOf(); the cells are csvCells().
class CsvTable {
public:
    /// @param file for messages
    /// @throw InputError without a header line, for two columns of the same name, or for a row with
    ///        another number of cells than the header, each with its line; for a table that takes
    ///        more memory than an input may
    CsvTable(std::string_view content, std::string file);

    [[nodiscard]] std::size_t rows() const { return rows_.size(); }
    [[nodiscard]] const std::vector<std::string>& columns() const { return names_; }
    [[nodiscard]] bool has(const std::string& column) const { return index_.contains(column); }
    /// Returns the file's name, for messages.
    [[nodiscard]] const std::string& file() const { return file_; }

    /// @throw InputError when there is no such column
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const {
        return std::string(view(row, column));
    }
    /// text() without a copy; it lives as long as the table. @throw InputError as text()
    [[nodiscard]] std::string_view view(std::size_t row, const std::string& column) const;
    /// The cell as a number ("nan" and "inf" are numbers), whatever the locale.
    /// @throw InputError when there is no such column or the cell is no number
    [[nodiscard]] double number(std::size_t row, const std::string& column) const;
    /// A whole column of numbers. @throw InputError as number()
    [[nodiscard]] std::vector<double> numbers(const std::string& column) const;

    /// Line of the file that holds this row, from 1, for messages.
    [[nodiscard]] std::size_t line(std::size_t row) const { return rows_.at(row).line; }

private:
    struct Row {
        std::size_t begin = 0;  ///< of its cells, in the text of all
        std::size_t line = 0;   ///< of the file
    };

    void addLine(std::string_view line, std::size_t number);
    void addRow(const std::vector<std::string>& cells, std::size_t number);
    void setHeader(std::vector<std::string> names, std::size_t number);
    [[nodiscard]] std::size_t columnIndex(const std::string& name) const;
    [[nodiscard]] std::string_view cellAt(std::size_t row, std::size_t column) const;
    [[nodiscard]] double numberAt(std::size_t row, std::size_t column) const;
    [[noreturn]] void fail(std::size_t line, const std::string& what) const;

    std::string file_;
    std::vector<std::string> names_;
    std::map<std::string, std::size_t> index_;
    // A string for each cell would need ten times the file.
    std::string text_;                 ///< of all cells, row after row
    std::vector<std::uint32_t> ends_;  ///< of each cell, from its row's begin
    std::vector<Row> rows_;
    std::vector<std::string> cells_;  ///< of the row that is added
};

/// Reads a whole file. @throw InputError when it cannot be read, and as CsvTable
[[nodiscard]] CsvTable readCsv(const std::filesystem::path& path);

/// Reads the whole lines of a table whose writing was cut off. After a power cut a file may
/// end in zeros. @throw InputError as readCsv()
[[nodiscard]] CsvTable readUnfinishedCsv(const std::filesystem::path& path);
/// The whole lines at the start of such a table.
[[nodiscard]] std::string_view wholeLines(std::string_view content);

/// Splits a line of CSV into its cells, without the blanks around them; a cell in double quotes may
/// hold commas, and a doubled quote means one.
/// @param most  cells that are kept: those beyond are counted only
/// @param cells their room is used again
/// @return how many there are; 0: a quoted cell is not closed
std::size_t splitCells(std::string_view line, std::size_t most, std::vector<std::string>& cells);

/// Splits the line that names the columns of a table; renamed ones get their current names.
/// @param refuse (sentence) throws
/// @throw what `refuse` throws for a quoted cell that is not closed or for too many columns
template <class Refuse>
[[nodiscard]] std::vector<std::string> columnNamesOf(std::string_view line, const Refuse& refuse) {
    constexpr std::size_t kMaxColumns = 10'000;
    std::vector<std::string> names;
    const std::size_t count = splitCells(line, kMaxColumns, names);
    if (count == 0) {
        refuse("a quoted cell is not closed");
    }
    if (count > kMaxColumns) {
        refuse("expected at most " + std::to_string(kMaxColumns) + " columns, found " +
               std::to_string(count));
    }
    return currentKeys(std::move(names));
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
    /// Returns the lines above the columns' names that start with `#`, without it.
    [[nodiscard]] const std::vector<std::string>& comments() const { return comments_; }

    /// @return false: there are no more rows. @throw InputError for a row with another number of
    /// cells than there are columns
    [[nodiscard]] bool next();
    /// Returns the cells of the present row.
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
