#include "core/io/tables/CsvRows.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>

namespace asperity {

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
