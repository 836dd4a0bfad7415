#include "core/io/tables/CsvTable.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/MemoryLimit.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace asperity {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

CsvTable::CsvTable(std::string_view content, std::string file) : file_(std::move(file)) {
    if (content.starts_with(kByteOrderMark)) {
        content.remove_prefix(kByteOrderMark.size());
    }
    const auto commas = static_cast<std::size_t>(std::ranges::count(content, ','));
    const auto lines = static_cast<std::size_t>(std::ranges::count(content, '\n'));
    requireMemory(content.size() + (commas + lines) * sizeof(ends_[0]) + lines * sizeof(Row), file_,
                  "");
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
    const auto refuse = [&](const std::string& what) { fail(number, what); };
    if (names_.empty()) {
        setHeader(columnNamesOf(line, refuse), number);
        return;
    }
    splitRow(line, names_.size(), cells_, refuse);
    addRow(cells_, number);
}

void CsvTable::addRow(const std::vector<std::string>& cells, std::size_t number) {
    rows_.push_back({.begin = text_.size(), .line = number});
    for (const std::string& cell : cells) {
        text_ += cell;
        const std::size_t end = text_.size() - rows_.back().begin;
        if (end > std::numeric_limits<std::uint32_t>::max()) {
            fail(number, "expected a row of less than 4 GiB");
        }
        ends_.push_back(static_cast<std::uint32_t>(end));
    }
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

std::string_view CsvTable::view(std::size_t row, const std::string& column) const {
    return cellAt(row, columnIndex(column));
}

std::string_view CsvTable::cellAt(std::size_t row, std::size_t column) const {
    const std::size_t cell = row * names_.size() + column;
    const std::size_t begin = column == 0 ? 0 : ends_.at(cell - 1);
    return std::string_view(text_).substr(rows_.at(row).begin + begin, ends_.at(cell) - begin);
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
    const std::string_view cell = cellAt(row, column);
    const std::optional<double> value = parseNumber(cell);
    if (!value) {
        fail(line(row), "column '" + names_[column] + "': expected a number, found '" +
                            std::string(cell) + "'");
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

std::size_t splitCells(std::string_view line, std::size_t most, std::vector<std::string>& cells) {
    std::size_t count = 0;
    std::string cell;
    const auto end = [&] {
        if (count < most) {
            cells.resize(std::max(cells.size(), count + 1));
            cells[count].assign(trimmed(cell));
        }
        ++count;
        cell.clear();
    };
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line[i] == '"' && line.substr(i + 1).starts_with('"');
        if (doubled) {
            cell += line[++i];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            end();
        } else {
            cell += line[i];
        }
    }
    if (quoted) {
        return 0;
    }
    end();
    cells.resize(std::min(count, most));
    return count;
}

CsvRows::CsvRows(const std::filesystem::path& path) : bytes_(path), lines_(bytes_) {
    const std::optional<std::string_view> line = nextLine();
    if (!line) {
        throw InputError(path.string(), "", "expected a line that names the columns");
    }
    columns_ = columnNamesOf(*line, [this](const std::string& what) { lines_.fail(what); });
}

/// The next line that is neither empty nor a comment.
std::optional<std::string_view> CsvRows::nextLine() {
    while (const std::optional<std::string_view> read = lines_.next()) {
        const std::string_view line = trimmed(*read);
        if (line.starts_with('#')) {
            if (columns_.empty()) {
                comments_.emplace_back(trimmed(line.substr(1)));
            }
        } else if (!line.empty()) {
            return line;
        }
    }
    return std::nullopt;
}

bool CsvRows::next() {
    const std::optional<std::string_view> line = nextLine();
    if (!line) {
        return false;
    }
    splitRow(*line, columns_.size(), cells_,
             [this](const std::string& what) { lines_.fail(what); });
    return true;
}

}  // namespace asperity
