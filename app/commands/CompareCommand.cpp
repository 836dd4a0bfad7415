#include "app/commands/CompareCommand.h"

#include "app/commands/CaseFiles.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/loading/ComparedRun.h"
#include "app/program/JsonText.h"
#include "app/recording/RunComparison.h"
#include "app/runs/RunFolder.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/TemporaryFile.h"
#include "core/io/tables/CsvWriter.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

namespace asperity {

namespace {

struct CompareOptions {
    std::string first;
    std::string second;
    std::string out;  ///< empty: no table
    bool force = false;
    bool json = false;
};

/// What is told of two runs.
struct Compared {
    std::pair<std::string, std::string> names;
    ComparedRun first;
    ComparedRun second;
    RunComparison forces;
    std::vector<std::string> differences;
};

ComparedRun read(const std::string& run, const std::string& name) {
    ProgressLine line("reading " + name);
    ComparedRun compared = readComparedRun(run, &line);
    if (!compared.note.empty()) {
        std::cerr << "note: " << name << ": " << compared.note << '\n';
    }
    return compared;
}

Compared compared(const CompareOptions& options) {
    Compared runs;
    runs.names = runNames(options.first, options.second);
    runs.first = read(options.first, runs.names.first);
    runs.second = read(options.second, runs.names.second);
    runs.forces = compareRuns(runs.first.trace, runs.second.trace);
    runs.differences = differencesOf(runs.first.conditions, runs.second.conditions);
    return runs;
}

void print(const Compared& runs) {
    const RunComparison& forces = runs.forces;
    std::cout << "normal force of " << runs.names.second << " minus that of " << runs.names.first
              << ", at equal time since the start\n"
              << "  mean:     " << formatSi(forces.mean, "N") << '\n'
              << "  rms:      " << formatSi(forces.rms, "N") << '\n'
              << "  largest:  " << formatSi(forces.largest.difference(), "N")
              << formatted(" at %.6g s", forces.largest.time) << '\n'
              << formatted("  overlap:  %.6g s of %.6g s and %.6g s, %zu ticks compared\n",
                           forces.overlap, runs.first.trace.duration(),
                           runs.second.trace.duration(), forces.ticks.size());
    if (forces.excluded > 0) {
        std::cout << "  excluded: " << forces.excluded
                  << " ticks with a fault or without a number\n";
    }
    std::cout << (runs.differences.empty() ? "scan and parameters are the same\n"
                                           : "what else differs, first → second:\n");
    for (const std::string& difference : runs.differences) {
        std::cout << "  " << printable(difference) << '\n';
    }
}

std::string jsonOf(const Compared& runs) {
    const RunComparison& forces = runs.forces;
    const auto run = [](const std::string& name, const ForceTrace& trace) {
        return nlohmann::ordered_json{
            {"name", name}, {"ticks", trace.size()}, {"duration_s", trace.duration()}};
    };
    return jsonText(nlohmann::ordered_json{{"first", run(runs.names.first, runs.first.trace)},
                                           {"second", run(runs.names.second, runs.second.trace)},
                                           {"difference",
                                            {{"mean_n", forces.mean},
                                             {"rms_n", forces.rms},
                                             {"largest_n", forces.largest.difference()},
                                             {"largest_at_s", forces.largest.time}}},
                                           {"overlap_s", forces.overlap},
                                           {"compared_ticks", forces.ticks.size()},
                                           {"excluded_ticks", forces.excluded},
                                           {"differs", runs.differences}});
}

void writeDifferences(std::ostream& out, const Compared& runs) {
    CsvWriter csv(out,
                  {"normal forces of two runs at equal time since the start of each",
                   "first: " + runs.names.first, "second: " + runs.names.second,
                   "difference: second minus first"},
                  {"time_s", "first_normal_force_n", "second_normal_force_n", "difference_n"});
    for (const ComparedForces& tick : runs.forces.ticks) {
        csv.row(std::vector<double>{tick.time, tick.first, tick.second, tick.difference()});
    }
    csv.close();
}

void compare(const CompareOptions& options) {
    if (!options.out.empty()) {
        requireOutside(options.first, options.out);
        requireOutside(options.second, options.out);
        requireFree(options.out, options.force);
        requireWritable(options.out);
    }
    const Compared runs = compared(options);
    if (!options.out.empty()) {
        writeTable(options.out, [&runs](std::ostream& out, Progress* /*progress*/) {
            writeDifferences(out, runs);
        });
    }
    if (options.json) {
        std::cout << jsonOf(runs) << '\n';
    } else {
        print(runs);
    }
}

}  // namespace

void addCompareCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "compare", "Compare the normal forces of two runs at equal time since the start");
    const auto options = std::make_shared<CompareOptions>();
    command
        ->add_option("RUN", options->first,
                     "folder that explore or a recording wrote, or a bundle (.zip)")
        ->required()
        ->check(notEmpty());
    command->add_option("OTHER", options->second, "the run that it is compared with")
        ->required()
        ->check(notEmpty());
    command
        ->add_option("--out", options->out, "CSV file to write both forces and the difference to")
        ->check(notEmpty());
    command->add_flag("--force", options->force, "replace a file of that name");
    command->add_flag("--json", options->json, "print JSON with SI values in full precision");
    command->callback([options] { compare(*options); });
}

}  // namespace asperity
