#include "core/io/tables/CaseTable.h"

#include "core/Error.h"

namespace asperity {

namespace {

/// The columns of the cases, then the added ones.
std::vector<std::string> joined(const CsvTable& cases, const std::vector<std::string>& added) {
    std::vector<std::string> columns = cases.columns();
    for (const std::string& name : added) {
        if (cases.has(name)) {
            throw InputError(cases.file(), "header",
                             "the column '" + name + "' is one that is added here");
        }
        columns.push_back(name);
    }
    return columns;
}

}  // namespace

CsvTable readCases(const std::filesystem::path& file, const std::vector<std::string>& required) {
    CsvTable cases = readCsv(file);
    for (const std::string& column : required) {
        if (!cases.has(column)) {
            throw InputError(cases.file(), "header", "expected a column '" + column + "'");
        }
    }
    return cases;
}

void writeCases(std::ostream& out, const CsvTable& cases, const CaseAnswers& answers,
                Progress* progress) {
    constexpr std::size_t kRowsAReport = 16;
    CsvWriter csv(out, answers.comments, joined(cases, answers.columns));
    for (std::size_t row = 0; row < cases.rows(); ++row) {
        if (row % kRowsAReport == 0) {
            reportTo(progress, static_cast<double>(row) / static_cast<double>(cases.rows()));
        }
        for (const std::string& column : cases.columns()) {
            csv.add(cases.view(row, column));
        }
        answers.add(csv, row);
        csv.endRow();
    }
    reportTo(progress, 1.0);
    csv.close();
}

}  // namespace asperity
