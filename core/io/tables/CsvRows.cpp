#include "core/io/tables/CsvRows.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <optional>

namespace asperity {

std::vector<std::string> csvCells(std::string_view line) {
    std::vector<std::string> cells;
    std::string cell;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool doubled = quoted && line[i] == '"' && line.substr(i + 1).starts_with('"');
        if (doubled) {
            cell += line[++i];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            cells.emplace_back(trimmed(cell));
            cell.clear();
        } else {
            cell += line[i];
        }
    }
    if (quoted) {
        return {};
    }
    cells.emplace_back(trimmed(cell));
    return cells;
}

CsvRows::CsvRows(const std::filesystem::path& path) : bytes_(path), lines_(bytes_) {
    if (!nextCells(columns_)) {
        throw InputError(path.string(), "", "expected a line that names the columns");
    }
}

bool CsvRows::nextCells(std::vector<std::string>& cells) {
    while (const std::optional<std::string_view> read = lines_.next()) {
        const std::string_view line = trimmed(*read);
        if (line.starts_with('#')) {
            if (columns_.empty()) {
                comments_.emplace_back(trimmed(line.substr(1)));
            }
        } else if (!line.empty()) {
            cells = csvCells(line);
            if (cells.empty()) {
                lines_.fail("a quoted cell is not closed");
            }
            return true;
        }
    }
    return false;
}

bool CsvRows::next() {
    if (!nextCells(cells_)) {
        return false;
    }
    if (cells_.size() != columns_.size()) {
        lines_.fail("expected " + std::to_string(columns_.size()) +
                    " cells as in the header, found " + std::to_string(cells_.size()));
    }
    return true;
}

}  // namespace asperity
