#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/VirtualDisplay.h"
#include "app/program/EndSignals.h"
#include "app/program/JsonText.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/ProgramRun.h"
#include "core/Progress.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <thread>
#include <vector>

namespace asperity {

namespace {

/// A measurement, by a program of its own beside this one: some are linked with programs that
/// ours is compared with, whose licenses differ from ours.
struct Measurement {
    const char* name;
    const char* program;
};
constexpr Measurement kMeasurements[] = {{"closest-point", "asperity_surface_bench"},
                                         {"fit", "asperity_fit_bench"},
                                         {"contact", "asperity_contact_bench"},
                                         {"load", "asperity_load_bench"},
                                         {"curves", "asperity_curve_bench"},
                                         {"needs", "asperity_needs_bench"},
                                         {"feedback", "asperity_feedback_bench"},
                                         {"view", "asperity_view_bench"},
                                         {"program", "asperity_program_bench"},
                                         {"scaling", "asperity_scaling_bench"},
                                         {"tick", "asperity_tick_bench"}};

struct BenchRequest {
    std::vector<std::string> only;  ///< names; empty: all
    std::string json;               ///< file; empty: none
    bool quick = false;
};

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Measurement& measurement : kMeasurements) {
        all.emplace_back(measurement.name);
    }
    return all;
}

std::filesystem::path programOf(const Measurement& measurement) {
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe").replace_filename(measurement.program);
    if (!std::filesystem::exists(program)) {
        throw Error("the measurements are not built: they come with the sources, not with an "
                    "installed program (tools/build.sh release asperity_benchmarks)");
    }
    return program;
}

std::vector<Measurement> wantedOf(const BenchRequest& options) {
    std::vector<Measurement> wanted;
    for (const Measurement& measurement : kMeasurements) {
        if (options.only.empty() ||
            std::ranges::find(options.only, measurement.name) != options.only.end()) {
            wanted.push_back(measurement);
            (void)programOf(measurement);  // what is missing is reported before the work
        }
    }
    return wanted;
}

/// Runs a program to its end. @throw Canceled by a signal: all that was started ends, too
ProgramOutcome outcomeOf(const ProgramCall& call) {
    const CancelOnSignal signals;
    RunningProgram program(call);
    std::optional<ProgramOutcome> outcome;
    while (!outcome) {
        if (CancelOnSignal::hasArrived()) {
            throw Canceled();
        }
        outcome = program.look();
    }
    return *outcome;
}

nlohmann::ordered_json measured(const Measurement& measurement, const std::filesystem::path& file,
                                bool quick) {
    std::cerr << "measuring: " << measurement.name << '\n';
    std::vector<std::string> arguments{"--rows", file.string()};
    if (quick) {
        arguments.emplace_back("--quick");
    }
    ProgramCall call = trustedCall(programOf(measurement), arguments);
    call.output = ProgramStream::Dropped;
    call.errors = ProgramStream::Shared;
    const ProgramOutcome outcome = outcomeOf(call);
    std::ifstream stream(file);
    auto rows = nlohmann::ordered_json::parse(stream, nullptr, false);
    if (outcome.end != ProgramEnd::Exited || outcome.exitCode != 0 || !rows.is_array()) {
        throw Error(std::string(measurement.program) + " has failed");
    }
    return rows;
}

/// @param row as bench/BenchRows.cpp writes it
std::string lineOf(const nlohmann::ordered_json& row) {
    const auto text = [&row](const char* key) { return row.at(key).get<std::string>(); };
    const char* const relation = text("goal_is") == "at_least" ? ">=" : "<=";
    const std::string goal = formatted("%s %g", relation, row.at("goal").get<double>());
    if (row.at("value").is_null()) {
        return formatted("%-72s %9s %-8s  %-9s not installed", text("name").c_str(), "-", "",
                         goal.c_str());
    }
    return formatted("%-72s %9.3g %-8s  %-9s %s", text("name").c_str(),
                     row.at("value").get<double>(), text("unit").c_str(), goal.c_str(),
                     row.at("met").get<bool>() ? "met" : "not met");
}

void print(const nlohmann::ordered_json& rows) {
    int met = 0;
    int missed = 0;
    for (const auto& row : rows) {
        std::cout << lineOf(row) << '\n';
        if (row.at("met").is_boolean()) {
            ++(row.at("met").get<bool>() ? met : missed);
        }
    }
    std::cout << met << " goals met, " << missed << " not met, "
              << rows.size() - static_cast<std::size_t>(met + missed)
              << " beside programs that are not installed (tools/install_peers.sh)\n";
}

void bench(const BenchRequest& options) {
    const std::vector<Measurement> wanted = wantedOf(options);
    if (!options.json.empty()) {
        requireWritable(options.json);
    }
    const VirtualDisplay display;
    const PrivateFolder folder;
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Measurement& measurement : wanted) {
        const auto more = measured(measurement, folder.path() / measurement.name, options.quick);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    print(rows);
    if (!options.json.empty()) {
        OutputFile file(options.json);
        file.stream() << jsonText(nlohmann::ordered_json{
                             {"version", kVersion},
                             {"processors", std::thread::hardware_concurrency()},
                             {"quick", options.quick},
                             {"rows", rows}})
                      << '\n';
        file.commit();
    }
}

}  // namespace

void addBenchCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "bench", "Measure how fast the program is, beside its goals and other programs");
    const auto options = std::make_shared<BenchRequest>();
    command->add_option("WHAT", options->only, "what to measure; default: all")
        ->check(CLI::IsMember(names()));
    command->add_flag("--quick", options->quick, "fewer repeats and smaller maps");
    command->add_option("--json", options->json, "file for the rows")->check(notEmpty());
    command->callback([options] { bench(*options); });
}

}  // namespace asperity
