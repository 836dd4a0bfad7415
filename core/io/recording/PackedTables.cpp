#include "core/io/recording/PackedTables.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/FormerKeys.h"
#include "core/io/TextValue.h"
#include "core/io/hdf5/Hdf5TableWriter.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/RowChecks.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <string>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kInput = "tick_input";
constexpr const char* kLog = "force_log";
constexpr const char* kEnergy = "energy_log";
constexpr const char* kChecks = "force_log_checks";
constexpr const char* kFormat = "asperity recording";
constexpr const char* kFormatVersion = "1";
constexpr const char* kTime = "time_s";

/// Returns the shape of a table as text.
Hdf5Table shapeOf(const std::filesystem::path& text) {
    CsvRows rows(text);
    Hdf5Table table{.columns = {}, .comments = rows.comments()};
    for (const std::string& name : rows.columns()) {
        table.columns.push_back({.name = name, .unit = unitOfColumn(name), .sameAs = {}});
    }
    for (; rows.next(); ++table.rows) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const std::string& cell = rows.cells()[c];
            Hdf5Column& column = table.columns[c];
            column.width = std::max(column.width, cell.size());
            if (column.type == Hdf5Column::Type::Double && !parseNumber(cell)) {
                column.type = Hdf5Column::Type::Text;
            }
        }
    }
    return table;
}

/// Columns of a log that hold what columns of the input hold, in each row.
class SharedColumns {
public:
    SharedColumns(const std::vector<Hdf5Column>& log, const std::vector<Hdf5Column>& input) {
        for (std::size_t l = 0; l < log.size(); ++l) {
            for (std::size_t i = 0; i < input.size(); ++i) {
                if (!log[l].unit.empty() && log[l].unit == input[i].unit &&
                    log[l].type == input[i].type) {
                    pairs_.emplace_back(l, i);
                }
            }
        }
    }

    void take(const std::vector<std::string>& log, const std::vector<std::string>& input) {
        std::erase_if(pairs_,
                      [&](const auto& pair) { return log[pair.first] != input[pair.second]; });
    }

    /// Has the log's columns name the input's.
    void apply(std::vector<Hdf5Column>& log, const std::vector<Hdf5Column>& input) const {
        for (const auto& [l, i] : pairs_) {
            log[l].sameAs = std::string("/") + kInput + "/" + input[i].name;
        }
    }

private:
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Columns of the log that hold the same as columns of the input name those.
void shareColumns(Hdf5Table& log, const Hdf5Table& input, const TextTables& tables) {
    if (log.rows != input.rows) {
        return;
    }
    SharedColumns shared(log.columns, input.columns);
    CsvRows ofLog(tables.log);
    CsvRows ofInput(tables.input);
    while (ofLog.next() && ofInput.next()) {
        shared.take(ofLog.cells(), ofInput.cells());
    }
    shared.apply(log.columns, input.columns);
}

/// The log as it is stored beside the input.
Hdf5Table shapeOfLog(const TextTables& tables, const Hdf5Table& input) {
    Hdf5Table log = shapeOf(tables.log);
    shareColumns(log, input, tables);
    for (Hdf5Column& column : log.columns) {
        if (column.type == Hdf5Column::Type::Double && column.sameAs.empty() &&
            column.name != kTime) {
            column.type = Hdf5Column::Type::Single;
        }
    }
    return log;
}

void addRow(Hdf5TableWriter& writer, const std::vector<std::string>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (writer.type(c) == Hdf5Column::Type::Text) {
            writer.add(std::string_view(cells[c]));
        } else {
            writer.add(parseNumber(cells[c]).value_or(0.0));
        }
    }
    writer.endRow();
}

void packTable(const Hdf5Output& file, const char* name, const Hdf5Table& table,
               const std::filesystem::path& text, RowChecks* checks = nullptr) {
    CsvRows rows(text);
    Hdf5TableWriter writer(file, name, table);
    while (rows.next()) {
        addRow(writer, rows.cells());
        if (checks != nullptr) {
            std::ranges::for_each(rows.cells(), [&](const auto& cell) { checks->add(cell); });
            checks->endRow();
        }
    }
    writer.close();
}

/// The shortest text that reads back as the same float.
std::string singleText(double number) {
    std::array<char, 32> text{};
    const auto result =
        std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(number));
    return {text.data(), result.ptr};
}

void addCell(CsvWriter& csv, const Hdf5Rows& rows, std::size_t column) {
    switch (rows.columns()[column].type) {
    case Hdf5Column::Type::Double:
        csv.add(rows.number(column));
        break;
    case Hdf5Column::Type::Single:
        csv.add(singleText(rows.number(column)));
        break;
    case Hdf5Column::Type::Text:
        csv.add(rows.text(column));
        break;
    }
}

void unpackTable(const Hdf5Input& file, const char* name, std::ostream& text) {
    Hdf5Rows rows(file, name);
    std::vector<std::string> names;
    for (const Hdf5Column& column : rows.columns()) {
        names.push_back(column.name);
    }
    CsvWriter csv(text, rows.comments(), currentKeys(std::move(names)));
    while (rows.next()) {
        for (std::size_t c = 0; c < rows.columns().size(); ++c) {
            addCell(csv, rows, c);
        }
        csv.endRow();
    }
    csv.close();
}

CsvTable readTable(const Hdf5Input& file, const char* name) {
    std::ostringstream text;
    unpackTable(file, name, text);
    return {text.view(), file.name() + ": " + name};
}

Hdf5Input opened(const std::filesystem::path& packed, const std::vector<std::string>& wanted) {
    Hdf5Input file(packed, wanted);
    if (file.attribute("format") != kFormat || file.attribute("format_version") != kFormatVersion) {
        throw InputError(packed.string(), "",
                         "expected the tables of a recording, format version 1");
    }
    return file;
}

}  // namespace

void packTables(const TextTables& tables, const std::filesystem::path& packed) {
    const TemporaryFile target(packed);
    Hdf5Output file(target.path());
    file.setAttribute("format", kFormat);
    file.setAttribute("format_version", kFormatVersion);
    file.setAttribute("version", kVersion);
    const Hdf5Table input = shapeOf(tables.input);
    packTable(file, kInput, input, tables.input);
    RowChecks checks;
    packTable(file, kLog, shapeOfLog(tables, input), tables.log, &checks);
    file.addList(kChecks, checks.checks());
    if (!tables.energy.empty()) {
        packTable(file, kEnergy, shapeOf(tables.energy), tables.energy);
    }
    file.close();
    target.sync();
    target.commit();
}

CsvTable readPackedInput(const std::filesystem::path& packed) {
    return readTable(opened(packed, {kInput}), kInput);
}

PackedLog readPackedLog(const std::filesystem::path& packed) {
    const Hdf5Input file = opened(packed, {kLog, kChecks});
    PackedLog log{.rows = readTable(file, kLog), .checks = file.list(kChecks)};
    if (log.checks.size() != (log.rows.rows() + RowChecks::kRows - 1) / RowChecks::kRows) {
        file.fail(kChecks, "expected a check of each " + std::to_string(RowChecks::kRows) +
                               " rows of force_log");
    }
    return log;
}

void unpackTables(const std::filesystem::path& packed, const TextTables& tables) {
    const Hdf5Input file = opened(packed, {kInput, kEnergy});
    const auto unpack = [&file](const char* name, const std::filesystem::path& path) {
        OutputFile text(path);
        unpackTable(file, name, text.stream());
        text.commit();
    };
    unpack(kInput, tables.input);
    if (file.has(kEnergy)) {
        unpack(kEnergy, tables.energy);
    }
}

}  // namespace asperity
