#include "app/commands/CaseFiles.h"
#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/exports/PictureExport.h"
#include "app/loading/ComparedRun.h"
#include "app/program/EndSignals.h"
#include "app/program/JsonText.h"
#include "app/program/LoadedScene.h"
#include "app/recording/Bundle.h"
#include "app/recording/Replay.h"
#include "app/recording/RunComparison.h"
#include "app/recording/RunPacking.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/TemporaryFile.h"
#include "core/io/tables/CsvWriter.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>

namespace asperity {

namespace {

struct CompareOptions {
    std::string first;
    std::string second;
    std::string out;  ///< empty: no table
    bool force = false;
    bool json = false;
};

/// Results of comparing two runs.
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

struct ReplayOptions {
    std::string run;
    std::string out;
    bool force = false;
};

void tellOutcome(const RecordedRun& run) {
    const std::string cutOff = sentenceOf(run.state);
    if (!cutOff.empty()) {
        std::cerr << "note: " << cutOff << '\n';
    }
    if (run.samples.empty()) {
        std::cerr << "note: the recording ended before its first tick was written\n";
    }
    std::cout << "bit-identical: " << run.samples.size() << " ticks\n";
}

void replayFolder(const std::filesystem::path& folder, const ReplayOptions& options) {
    const std::filesystem::path target = options.out;
    if (std::filesystem::exists(target) && std::filesystem::equivalent(folder, target)) {
        throw Error("--out must be another folder than the run: its logs would be overwritten");
    }
    const RecordedRun run = readRun(folder);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    requireSameScan(loaded, run.scan);
    OutputFolder out(target, replayedLogs(), options.force);
    std::optional<CsvTable> replayed;
    out.collect([&](const std::filesystem::path& collected) {
        replayed.emplace(replay(loaded.scene, run, collected));
    });
    out.commit();
    try {
        requireSameLog(run, *replayed);
    } catch (const FileError&) {
        throw;
    } catch (const Error& difference) {
        throw Error(failureOfReplay(difference.what(), loaded, run.scan));
    }
    tellOutcome(run);
}

void runReplay(const ReplayOptions& options) {
    const RunLocation input(options.run);
    input.read([&] { replayFolder(input.folder(), options); });
}

struct BundleOptions {
    std::string run;
    std::string out;
    RunSpan span{.from = -std::numeric_limits<double>::infinity(),
                 .to = std::numeric_limits<double>::infinity()};
    bool isPart = false;
    bool force = false;
};

/// A bundle of a run that is not what it says would show others something else than its tables.
void requireReplay(const std::string& name, const LoadedScene& loaded, const RecordedRun& run,
                   const std::filesystem::path& scratch) {
    ProgressLine line("replaying");
    const std::string difference = differenceOnReplay(loaded.scene, run, scratch, {}, &line);
    if (!difference.empty()) {
        throw Error(name + ": does not replay: " + failureOfReplay(difference, loaded, run.scan));
    }
}

/// The run or its part, checked. @return its folder: that of the run, or one in `scratch`
std::filesystem::path checkedRun(const BundleOptions& options, const std::filesystem::path& folder,
                                 const std::filesystem::path& scratch) {
    const RecordedRun run = readRun(folder);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    requireSameScan(loaded, run.scan);
    requireReplay(options.run, loaded, run, scratch / "replay");
    if (!options.isPart && run.state == RunState::Complete) {
        return folder;
    }
    writeSlice(folder, loaded, run, options.span, scratch / "run");
    return scratch / "run";
}

void draw(const std::filesystem::path& run, const std::filesystem::path& picture) {
    ProgressLine line("drawing");
    ExportInput input(run, &line);
    writeExport(input, {}, picture, ExportFormat::Png, &line);
}

void bundle(const BundleOptions& options) {
    const CancelOnSignal cancel;   // between one piece of work and the next, too
    const VirtualDisplay display;  // before long work: the picture needs it
    if (options.span.from > options.span.to) {
        throw Error(
            formatted("--from %g s is after --to %g s", options.span.from, options.span.to));
    }
    const PrivateFolder scratch;  // sweeps what a killed one left, also where this one is refused
    requireOutside(options.run, options.out);
    requireFree(options.out, options.force);
    const RunLocation input(options.run);
    input.read([&] {
        const std::filesystem::path run = checkedRun(options, input.folder(), scratch.path());
        const std::filesystem::path picture = scratch.path() / "picture.png";
        draw(run, picture);
        ProgressLine line("packing");
        writeBundle(run, picture, options.out, &line);
    });
    std::cout << printable(options.out) << ": " << std::filesystem::file_size(options.out)
              << " bytes; it opens and replays on any machine\n";
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

void addReplayCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "replay", "Replay a recorded run; check that every tick is bit-identical");
    const auto options = std::make_shared<ReplayOptions>();
    command
        ->add_option("RUN", options->run,
                     "folder that explore or a recording wrote, or a bundle (.zip)")
        ->required();
    addOutputFolder(*command, options->out, "folder for the replayed logs");
    addForce(*command, options->force);
    command->callback([options] { runReplay(*options); });
}

void addBundleCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "bundle", "Put a run, or a part of it, with its scan and a picture into one file");
    const auto options = std::make_shared<BundleOptions>();
    command->add_option("RUN", options->run, "folder that explore or a recording wrote")
        ->required();
    command->add_option("OUT", options->out, "file to write, a zip archive")
        ->required()
        ->check(notEmpty());
    CLI::Option* const from = command
                                  ->add_option("--from", options->span.from,
                                               "first moment of a part, since the first tick [s]")
                                  ->check(finiteNumber());
    CLI::Option* const to =
        command->add_option("--to", options->span.to, "last moment of a part, in the same form [s]")
            ->check(finiteNumber());
    command->add_flag("--force", options->force, "replace a file of that name");
    command->callback([options, from, to] {
        options->isPart = from->count() + to->count() > 0;
        bundle(*options);
    });
}

}  // namespace asperity
