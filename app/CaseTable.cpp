#include "app/CaseTable.h"

#include "app/OptionChecks.h"
#include "core/Error.h"

#include <algorithm>
#include <iostream>

namespace asperity {

namespace {

CsvTable readCases(const std::string& file, const std::vector<std::string>& required) {
    CsvTable table = readCsv(file);
    for (const std::string& column : required) {
        if (std::ranges::find(table.columns(), column) == table.columns().end()) {
            throw InputError(file, "", "expected a column '" + column + "'");
        }
    }
    return table;
}

std::vector<std::string> joined(std::vector<std::string> columns,
                                const std::vector<std::string>& added) {
    columns.insert(columns.end(), added.begin(), added.end());
    return columns;
}

CsvWriter openResult(const std::string& out, const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns) {
    if (out.empty()) {
        return {std::cout, comments, columns};
    }
    return {std::filesystem::path(out), comments, columns};
}

}  // namespace

void addCaseFiles(CLI::App& command, CaseFiles& files) {
    command.add_option("--cases", files.cases, "CSV table, one case a row")
        ->required()
        ->check(notEmpty());
    command.add_option("--out", files.out, "CSV file to write (default: standard output)")
        ->check(notEmpty());
}

CaseTable::CaseTable(const CaseFiles& files, const std::vector<std::string>& comments,
                     const std::vector<std::string>& required,
                     const std::vector<std::string>& added)
    : cases_(readCases(files.cases, required))
    , writer_(openResult(files.out, comments, joined(cases_.columns(), added))) {}

void CaseTable::beginRow(std::size_t row) {
    for (const std::string& column : cases_.columns()) {
        writer_.add(cases_.text(row, column));
    }
}

}  // namespace asperity
