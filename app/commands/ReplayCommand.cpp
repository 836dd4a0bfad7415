#include "app/commands/ReplayCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/program/LoadedScene.h"
#include "app/recording/Replay.h"
#include "app/recording/RunPlace.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

namespace asperity {

namespace {

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
    requireSameScan(loaded, folder);
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
        throw Error(failureOfReplay(difference.what(), loaded, folder));
    }
    tellOutcome(run);
}

void runReplay(const ReplayOptions& options) {
    const RunPlace input(options.run);
    input.read([&] { replayFolder(input.folder(), options); });
}

}  // namespace

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

}  // namespace asperity
