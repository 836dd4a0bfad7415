#include "tests/support/ReferenceTable.h"

#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace asperity::test {

namespace {

/// Splits one CSV line; a quoted cell may hold commas.
std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            cells.emplace_back();
        } else if (c != '\r') {
            cells.back() += c;
        }
    }
    return cells;
}

[[noreturn]] void fail(const std::string& message) {
    std::cerr << message << '\n';
    std::exit(1);  // NOLINT(concurrency-mt-unsafe): before any thread starts
}

}  // namespace

ReferenceTable::ReferenceTable(const std::filesystem::path& path) {
    std::ifstream file(path);
    if (!file) {
        fail("cannot open " + path.string());
    }
    std::string line;
    while (std::getline(file, line)) {
        if (line.empty() || line[0] == '#') {
            continue;
        }
        std::vector<std::string> cells = split(line);
        if (columns_.empty()) {
            for (std::size_t i = 0; i < cells.size(); ++i) {
                columns_[cells[i]] = i;
            }
        } else if (cells.size() != columns_.size()) {
            fail(path.string() + ": ragged row: " + line);
        } else {
            cells_.push_back(std::move(cells));
        }
    }
}

const std::string& ReferenceTable::text(std::size_t row, const std::string& column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end()) {
        fail("no column " + column);
    }
    return cells_.at(row).at(found->second);
}

double ReferenceTable::number(std::size_t row, const std::string& column) const {
    return std::strtod(text(row, column).c_str(), nullptr);
}

ReferenceTable referenceTable(const std::string& name) {
    return ReferenceTable(referenceFolder() / name);
}

std::filesystem::path sharedData(const std::string& relative) {
    return checkout() / ".." / "shared" / "data" / relative;
}

bool haveSharedData() {
    if (std::filesystem::exists(sharedData("afm/MANIFEST.csv"))) {
        return true;
    }
    const char* ci = std::getenv("CI");  // NOLINT(concurrency-mt-unsafe)
    if (ci != nullptr && std::string(ci) == "true") {
        ADD_FAILURE() << "CI=true, but ../shared/data is missing";
    }
    return false;
}

}  // namespace asperity::test
