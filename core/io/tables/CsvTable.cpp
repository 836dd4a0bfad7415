#include "core/io/tables/CsvTable.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/tables/CsvRows.h"

#include <utility>

namespace asperity {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

CsvTable::CsvTable(std::string_view content, std::string file) : file_(std::move(file)) {
    if (content.starts_with(kByteOrderMark)) {
        content.remove_prefix(kByteOrderMark.size());
    }
    for (std::size_t number = 1; !content.empty(); ++number) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        addLine(trimmed(content.substr(0, end)), number);
        content.remove_prefix(std::min(end + 1, content.size()));
    }
    if (names_.empty()) {
        throw InputError(file_, "", "expected a line that names the columns");
    }
}

void CsvTable::addLine(std::string_view line, std::size_t number) {
    if (line.empty() || line.starts_with('#')) {
        return;
    }
    std::vector<std::string> cells = csvCells(line);
    if (cells.empty()) {
        fail(number, "a quoted cell is not closed");
    }
    if (names_.empty()) {
        setHeader(std::move(cells), number);
        return;
    }
    if (cells.size() != names_.size()) {
        fail(number, "expected " + std::to_string(names_.size()) +
                         " cells as in the header, found " + std::to_string(cells.size()));
    }
    for (std::string& cell : cells) {
        cells_.push_back(std::move(cell));
    }
    lines_.push_back(number);
}

void CsvTable::setHeader(std::vector<std::string> names, std::size_t number) {
    for (const std::string& name : names) {
        if (name.empty()) {
            fail(number, "a column has no name");
        }
        if (!index_.emplace(name, index_.size()).second) {
            fail(number, "there are two columns '" + name + "'");
        }
    }
    names_ = std::move(names);
}

std::size_t CsvTable::columnIndex(const std::string& name) const {
    const auto found = index_.find(name);
    if (found == index_.end()) {
        throw InputError(file_, "header", "there is no column '" + name + "'");
    }
    return found->second;
}

const std::string& CsvTable::text(std::size_t row, const std::string& column) const {
    return cells_.at(row * names_.size() + columnIndex(column));
}

double CsvTable::number(std::size_t row, const std::string& column) const {
    return numberAt(row, columnIndex(column));
}

std::vector<double> CsvTable::numbers(const std::string& column) const {
    const std::size_t index = columnIndex(column);
    std::vector<double> values(rows());
    for (std::size_t row = 0; row < rows(); ++row) {
        values[row] = numberAt(row, index);
    }
    return values;
}

double CsvTable::numberAt(std::size_t row, std::size_t column) const {
    const std::string& cell = cells_.at(row * names_.size() + column);
    const std::optional<double> value = parseNumber(cell);
    if (!value) {
        fail(lines_.at(row),
             "column '" + names_[column] + "': expected a number, found '" + cell + "'");
    }
    return *value;
}

void CsvTable::fail(std::size_t line, const std::string& what) const {
    throw InputError(file_, "line " + std::to_string(line), what);
}

CsvTable readCsv(const std::filesystem::path& path) { return {readFileBytes(path), path.string()}; }

CsvTable readUnfinishedCsv(const std::filesystem::path& path) {
    return {wholeLines(readFileBytes(path)), path.string()};
}

std::string_view wholeLines(std::string_view content) {
    content = content.substr(0, content.find('\0'));
    return content.substr(0, content.rfind('\n') + 1);
}

}  // namespace asperity
