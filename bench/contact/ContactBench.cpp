// Time and error of each way to solve the Maugis-Dugdale law, beside SciPy, in one run. Times are
// medians over interleaved sweeps; the truth is the reference table of 25 digits.
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/contact/SciPyPeer.h"
#include "core/Error.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/io/tables/CsvTable.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr double kMaxTable = 100.0;       // indentation of the tables
constexpr double kRadiusSpan = 2.15;      // of lambda for a tenth to ten times the effective radius
constexpr double kMaxIndentation = 10.0;  // indentation of a sweep
constexpr int kRepeats = 201;
constexpr int kQuickRepeats = 21;
constexpr double kNewtonGoal = 800.0;
constexpr double kTableGoal = 20000.0;
constexpr std::size_t kMaxSweep = 400;  // short sweeps are seldom interrupted

struct Material {
    const char* name;
    double lambda;
};
constexpr Material kMaterials[] = {{"SiO2", 0.1879471378696118},
                                   {"polystyrene", 0.7199050683467632},
                                   {"rubber", 50.50262764553601}};

/// Values that the compiler must believe to be used.
volatile double used = 0.0;

/// A rate of solutions and what came out wrong.
struct Way {
    std::string name;
    std::function<void()> sweep;
    int solutions = 0;
    double goal = 0.0;  ///< ratio to SciPy; 0: none
    double error = 0.0;
    std::vector<double> times{};  ///< [ns] per solution

    [[nodiscard]] double median() {
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    }
};

void measure(std::vector<Way>& ways, int repeats) {
    for (int i = 0; i < repeats; ++i) {
        for (Way& way : ways) {
            const auto start = std::chrono::steady_clock::now();
            way.sweep();
            const std::chrono::duration<double, std::nano> taken =
                std::chrono::steady_clock::now() - start;
            way.times.push_back(taken.count() / way.solutions);
        }
    }
}

/// Indentations of an approach and a retraction in equal steps.
std::vector<double> sweepOf(const MaugisDugdale& law, double step) {
    const double low = law.lowestContact().indentation + 0.05;
    const auto steps = static_cast<std::size_t>((kMaxIndentation - low) / step);
    std::vector<double> sweep;
    for (std::size_t i = 0; i < std::min(steps, kMaxSweep); ++i) {
        sweep.push_back(low + (step * static_cast<double>(i)));
    }
    const std::vector<double> back(sweep.rbegin(), sweep.rend());
    sweep.insert(sweep.end(), back.begin(), back.end());
    return sweep;
}

double relative(double value, double exact) {
    return std::abs(value - exact) / std::max(std::abs(exact), 1.0);
}

/// Largest errors of the force over the stable states with contact of the reference table.
struct Errors {
    double cold = 0.0;
    double warm = 0.0;
    double table = 0.0;
    int states = 0;
};

Errors errorsAgainstReference() {
    const CsvTable reference = readCsv(ASPERITY_REFERENCE_FILE);
    constexpr double kNearFold = 1e-6;  // there rounding of the indentation decides
    Errors errors;
    for (std::size_t row = 0; row < reference.rows(); ++row) {
        const double lambda = reference.number(row, "lambda");
        const double indentation = reference.number(row, "delta_bar");
        const MaugisDugdale law(lambda);
        const auto control = MaugisControl::displacement();
        if (reference.text(row, "stability") != "stable" ||
            reference.text(row, "kind") != "contact" ||
            indentation - law.lowestContact().indentation < kNearFold * std::abs(indentation)) {
            continue;
        }
        const double force = reference.number(row, "P_bar");
        const MaugisPoint cold = law.stable(control, indentation).value();
        const MaugisPoint warm = law.stable(control, indentation, 1.05 * cold.coordinate).value();
        const MaugisTable table({lambda, lambda, std::max(kMaxTable, indentation)});
        errors.cold = std::max(errors.cold, relative(cold.force, force));
        errors.warm = std::max(errors.warm, relative(warm.force, force));
        errors.table =
            std::max(errors.table, relative(table.at(law, indentation).value().force, force));
        ++errors.states;
    }
    return errors;
}

/// Solving at each indentation of a sweep, one state the start of the next.
Way warmWay(const MaugisDugdale& law, const std::string& name, double step, double goal = 0.0) {
    const std::vector<double> sweep = sweepOf(law, step);
    const auto run = [&law, sweep] {
        MaugisPoint last;
        for (const double x : sweep) {
            last = *law.stable(MaugisControl::displacement(), x, last);
            used = last.force;
        }
    };
    return {.name = name, .sweep = run, .solutions = static_cast<int>(sweep.size()), .goal = goal};
}

Way coldWay(const MaugisDugdale& law) {
    const std::vector<double> sweep = sweepOf(law, 0.1);
    const auto run = [&law, sweep] {
        for (const double x : sweep) {
            used = law.stable(MaugisControl::displacement(), x)->force;
        }
    };
    return {
        .name = "exact, from scratch", .sweep = run, .solutions = static_cast<int>(sweep.size())};
}

Way tableForceWay(const MaugisDugdale& law, const MaugisTable& table, const std::string& name,
                  double goal = 0.0) {
    const std::vector<double> sweep = sweepOf(law, 0.1);
    const auto run = [&law, &table, sweep] {
        for (const double x : sweep) {
            used = table.at(law, x)->force;
        }
    };
    return {.name = name + ", force",
            .sweep = run,
            .solutions = static_cast<int>(sweep.size()),
            .goal = goal};
}

Way tableStateWay(const MaugisDugdale& law, const MaugisTable& table, const std::string& name) {
    const std::vector<double> sweep = sweepOf(law, 0.1);
    const auto run = [&law, &table, sweep] {
        for (const double x : sweep) {
            const MaugisState state = *table.at(law, x);
            used = state.force + state.stiffness + state.contactRadius + state.cohesiveRadius;
        }
    };
    return {
        .name = name + ", whole state", .sweep = run, .solutions = static_cast<int>(sweep.size())};
}

/// On a lever about as stiff as the contact: the equilibrium of one tick.
Way springWay(const MaugisDugdale& law, const MaugisTable& table) {
    constexpr double kCompliance = 0.5;
    const std::vector<double> sweep = sweepOf(law, 0.01);
    const auto run = [&law, &table, sweep] {
        double indentation = 1.0;
        for (const double x : sweep) {
            const auto state = table.stable(law, kCompliance, x + 1.0, indentation);
            indentation = state->indentation;
            used = state->force;
        }
    };
    return {.name = "table on a spring, steps of 0.01",
            .sweep = run,
            .solutions = static_cast<int>(sweep.size())};
}

/// Folds for a new effective radius, and on a spring: exact for every way above.
Way foldsWay(double lambda) {
    constexpr int kCount = 100;
    const auto run = [lambda] {
        for (int i = 0; i < kCount; ++i) {
            used = MaugisDugdale(lambda * (1.0 + (1e-4 * i)), MaugisDugdale::LoadFold::OnDemand)
                       .lowestContact()
                       .force;
        }
    };
    return {.name = "folds of a new radius", .sweep = run, .solutions = kCount};
}

Way springFoldWay(const MaugisDugdale& law) {
    constexpr int kCount = 100;
    const auto run = [&law] {
        for (int i = 0; i < kCount; ++i) {
            used = law.fold(MaugisControl::spring(0.5 + (1e-3 * i))).force;
        }
    };
    return {.name = "fold on a spring", .sweep = run, .solutions = kCount};
}

std::vector<ContactCase> peerCases(const MaugisDugdale& law) {
    std::vector<ContactCase> cases;
    for (const double x : sweepOf(law, 1.0)) {
        const double low = std::max(law.lowestContact().contactRadius, 1e-3);
        cases.push_back({.lambda = law.curve().lambda(),
                         .lowContactRadius = low,
                         .indentation = x,
                         .force = law.stable(MaugisControl::displacement(), x)->force});
    }
    return cases;
}

void print(Way& way, const std::optional<PeerTiming>& numpy,
           const std::optional<PeerTiming>& math) {
    const double time = way.median();
    std::printf("  %-34s %9.1f ns", way.name.c_str(), time);
    if (numpy && math) {
        std::printf("  %9.0f x  %9.0f x", numpy->nanoseconds / time, math->nanoseconds / time);
    }
    std::printf("\n");
}

void printPeer(const char* name, const std::optional<PeerTiming>& timing) {
    if (timing) {
        std::printf("  %-34s %9.1f ns   error %.1e\n", name, timing->nanoseconds, timing->error);
    } else {
        std::printf("  %-34s SciPy not installed (tools/install_peers.sh)\n", name);
    }
}

/// The ways that have a goal, as SciPy's time over theirs.
void addRows(const Material& material, std::vector<Way>& ways,
             const std::optional<PeerTiming>& numpy, std::vector<BenchRow>& rows) {
    for (Way& way : ways) {
        if (way.goal > 0.0) {
            BenchRow row{.name = std::string("Maugis-Dugdale, ") + material.name + ": SciPy over " +
                                 way.name,
                         .value = std::nullopt,
                         .unit = "x",
                         .goal = way.goal};
            if (numpy) {
                row.value = numpy->nanoseconds / way.median();
            }
            rows.push_back(row);
        }
    }
}

/// The shorter of both: a slow moment of the machine is nobody's time.
std::optional<PeerTiming> shorter(const std::optional<PeerTiming>& one,
                                  const std::optional<PeerTiming>& other) {
    if (!one || !other) {
        return std::nullopt;
    }
    return one->nanoseconds < other->nanoseconds ? one : other;
}

void benchMaterial(const Material& material, int repeats, std::vector<BenchRow>& rows) {
    const MaugisDugdale law(material.lambda);
    const MaugisTable flat({material.lambda, material.lambda, kMaxTable});
    const MaugisTable curved(
        {material.lambda / kRadiusSpan, material.lambda * kRadiusSpan, kMaxTable});
    std::vector<Way> ways{
        coldWay(law),
        warmWay(law, "warm Newton, steps of 0.1", 0.1, kNewtonGoal),
        warmWay(law, "warm Newton, steps of 0.001", 0.001),
        tableForceWay(law, flat, "table, one radius"),
        tableStateWay(law, flat, "table, one radius"),
        tableForceWay(law, curved, "table, R / 10 to 10 R", kTableGoal),
        tableStateWay(law, curved, "table, R / 10 to 10 R"),
        springWay(law, flat),
        springFoldWay(law),
        foldsWay(material.lambda),
    };
    const auto numpyBefore = timeSciPy("numpy", peerCases(law));
    measure(ways, repeats);
    const auto numpy = shorter(numpyBefore, timeSciPy("numpy", peerCases(law)));
    const auto math = timeSciPy("math", peerCases(law));
    std::printf("%s, lambda %.4f: time of one solution, ratio to SciPy (numpy, math)\n",
                material.name, material.lambda);
    printPeer("SciPy nested, numpy", numpy);
    printPeer("SciPy nested, math", math);
    for (Way& way : ways) {
        print(way, numpy, math);
    }
    addRows(material, ways, numpy, rows);
    std::printf("  tables: bound %.1e and %.1e, left to the exact law %.1f %% and %.1f %%, "
                "%.2f and %.2f MB\n\n",
                flat.errorBound(), curved.errorBound(), 100.0 * flat.exactShare(),
                100.0 * curved.exactShare(), 1e-6 * static_cast<double>(flat.bytes()),
                1e-6 * static_cast<double>(curved.bytes()));
}

BenchRow errorRow(const std::string& name, double error, double goal) {
    return {.name = "Maugis-Dugdale, 25-digit table: largest error of " + name,
            .value = error,
            .unit = "",
            .goal = goal,
            .kind = GoalKind::AtMost};
}

void benchAll(const BenchOptions& options) {
    std::vector<BenchRow> rows;
    for (const Material& material : kMaterials) {
        benchMaterial(material, options.quick ? kQuickRepeats : kRepeats, rows);
    }
    const Errors errors = errorsAgainstReference();
    std::printf("Largest error of the force over %d reference states: from scratch %.1e, warm "
                "Newton %.1e, table %.1e\n",
                errors.states, errors.cold, errors.warm, errors.table);
    rows.push_back(errorRow("warm Newton", errors.warm, 1e-11));
    rows.push_back(errorRow("the table", errors.table, 2e-9));
    giveRows(rows, options);
}

int runBench(int argc, char** argv) {
    BenchOptions options;
    CLI::App app("Maugis-Dugdale law: time and error of each way to solve it, beside SciPy");
    addBenchOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    benchAll(options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
