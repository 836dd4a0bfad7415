#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace asperity {

enum class GoalKind { AtLeast, AtMost };

/// One line of the table of `asperity bench`: a figure beside what it is to reach.
struct BenchRow {
    std::string name;             ///< "closest point, path: median of Embree over ours"
    std::optional<double> value;  ///< none: what it is compared with is not installed
    std::string unit;             ///< "x": a ratio
    double goal = 0.0;
    GoalKind kind = GoalKind::AtLeast;

    [[nodiscard]] bool isMet() const {
        return value && (kind == GoalKind::AtLeast ? *value >= goal : *value <= goal);
    }
};

/// Options of every program of measurements.
struct BenchOptions {
    std::string rows;    ///< file for the rows; empty: none
    bool quick = false;  ///< fewer repeats, smaller maps
};
void addBenchOptions(CLI::App& program, BenchOptions& options);

/// Prints rows for people, and writes them to the file of the options, if there is one, as a JSON
/// array. @throw Error when the file cannot be written
void giveRows(const std::vector<BenchRow>& rows, const BenchOptions& options);

}  // namespace asperity
