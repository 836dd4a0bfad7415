#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A CSV table with named columns of numbers or text. Lines that start with `#` and empty lines are
/// skipped; the first other line names the columns; the cells are csvCells().
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
    /// As given to the constructor, for messages.
    [[nodiscard]] const std::string& file() const { return file_; }

    /// @throw InputError when there is no such column
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const {
        return std::string(view(row, column));
    }
    /// As text(), without a copy; it holds as long as the table. @throw InputError as text()
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
    // A string for each cell would take ten times the file.
    std::string text_;                 ///< of all cells, row after row
    std::vector<std::uint32_t> ends_;  ///< of each cell, from its row's begin
    std::vector<Row> rows_;
    std::vector<std::string> cells_;  ///< of the row that is added
};

/// Reads a whole file. @throw InputError when it cannot be read, and as CsvTable
[[nodiscard]] CsvTable readCsv(const std::filesystem::path& path);

/// As far as whole lines go: for a table whose writing was cut off. After a power cut a file may
/// end in zeros. @throw InputError as readCsv()
[[nodiscard]] CsvTable readUnfinishedCsv(const std::filesystem::path& path);
/// The whole lines at the start of such a table.
[[nodiscard]] std::string_view wholeLines(std::string_view content);

}  // namespace asperity
