#include "bench/BenchRows.h"

#include "core/Error.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace asperity {

namespace {

nlohmann::ordered_json jsonOf(const BenchRow& row) {
    nlohmann::ordered_json json{{"name", row.name}};
    json["value"] = row.value ? nlohmann::ordered_json(*row.value) : nullptr;
    json["unit"] = row.unit;
    json["goal"] = row.goal;
    json["goal_is"] = row.kind == GoalKind::AtLeast ? "at_least" : "at_most";
    json["met"] = row.value ? nlohmann::ordered_json(row.isMet()) : nullptr;
    return json;
}

void print(const BenchRow& row) {
    const char* const relation = row.kind == GoalKind::AtLeast ? ">=" : "<=";
    if (row.value) {
        std::printf("%-66s %9.4g %-9s %s %g%s\n", row.name.c_str(), *row.value, row.unit.c_str(),
                    relation, row.goal, row.isMet() ? "" : "   not met");
    } else {
        std::printf("%-66s not installed (tools/install_peers.sh)\n", row.name.c_str());
    }
}

}  // namespace

void addBenchOptions(CLI::App& program, BenchOptions& options) {
    program.add_option("--rows", options.rows, "file for the figures and their goals, JSON");
    program.add_flag("--quick", options.quick, "fewer repeats and smaller maps");
}

void giveRows(const std::vector<BenchRow>& rows, const BenchOptions& options) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const BenchRow& row : rows) {
        print(row);
        json.push_back(jsonOf(row));
    }
    if (options.rows.empty()) {
        return;
    }
    std::ofstream stream(options.rows);
    stream << json.dump(2) << '\n';
    if (!stream.flush()) {
        throw Error(options.rows + ": cannot be written");
    }
}

}  // namespace asperity
