#include "app/commands/ReplayCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/program/LoadedScene.h"
#include "app/recording/RecordedRun.h"
#include "app/reports/OutputFolder.h"
#include "app/reports/RunFolder.h"
#include "core/Error.h"
#include "core/io/TextValue.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace asperity {

namespace {

struct ReplayOptions {
    std::string run;
    std::string out;
    bool force = false;
};

/// A run starts with its scene's settings and keeps its rate, but for whole periods that a live one
/// skips now and then: where the recorded input says otherwise, one of the two files was altered.
/// @throw Error naming the key
void requireSameSettings(const Scene& scene, const std::vector<TickSample>& samples) {
    const auto require = [](const std::string& key, double ofScene, double ofInput) {
        if (ofScene != ofInput) {
            throw Error("first differing tick: 0: " + key + " is " + exactText(ofScene) +
                        " in scene.toml, " + exactText(ofInput) + " in tick_input.csv");
        }
    };
    const auto shortest = std::min_element(samples.begin(), samples.end(),
                                           [](const TickSample& one, const TickSample& other) {
                                               return one.input.timeStep < other.input.timeStep;
                                           });
    require("time step (1 / rate_hz)", scene.timeStep(), shortest->input.timeStep);
    const TickInput& first = samples.front().input;
    require("position_gain", scene.settings.positionGain, first.settings.positionGain);
    require("force_gain", scene.settings.forceGain, first.settings.forceGain);
    require("position_control", static_cast<double>(scene.settings.positionControl),
            static_cast<double>(first.settings.positionControl));
    require("correction_hz", scene.settings.correctionBandwidth,
            first.settings.correctionBandwidth);
}

/// Runs the recorded inputs through the tick again and writes what comes out.
void runAgain(const Scene& scene, RecordedRun& run, const std::filesystem::path& out) {
    if (!run.samples.empty()) {
        requireSameSettings(scene, run.samples);
    }
    RunRecorder recorder(out);
    TickMemory memory = run.memory;
    for (TickSample& sample : run.samples) {
        sample.output = tick(scene, sample.input, memory);
        recorder.take(sample);
    }
    recorder.close();
}

/// Compares two force logs cell by cell, as text: the numbers are written to the last bit. Columns
/// that came after the recording was made are not in it.
/// @throw Error naming the first tick that differs
void compare(const RecordedRun& run, const CsvTable& replayed) {
    const CsvTable& recorded = run.log;
    const std::size_t common = std::min(recorded.rows(), replayed.rows());
    for (std::size_t row = 0; row < common; ++row) {
        for (const std::string& column : recorded.columns()) {
            const std::string& before = recorded.text(row, column);
            const std::string& now = replayed.text(row, column);
            if (before != now) {
                std::ostringstream difference;
                difference << "first differing tick: " << row << " (time "
                           << replayed.text(row, "time_s") << " s): " << column << " was " << before
                           << ", is now " << now;
                throw Error(difference.str());
            }
        }
    }
    if (run.state == RunState::Complete && recorded.rows() != replayed.rows()) {
        throw Error("first differing tick: " + std::to_string(common) + ": the recorded log has " +
                    std::to_string(recorded.rows()) + " ticks, the recorded input " +
                    std::to_string(replayed.rows()));
    }
}

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

void replay(const ReplayOptions& options) {
    const std::filesystem::path folder = options.run;
    const std::filesystem::path target = options.out;
    if (std::filesystem::exists(target) && std::filesystem::equivalent(folder, target)) {
        throw Error("--out must be another folder than the run: its logs would be overwritten");
    }
    RecordedRun run = readRun(folder);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    if (loaded.sha256 != run.sha256) {
        throw InputError(loaded.scene.description.sample.file, "",
                         "the scan has changed since the run was recorded (its hash differs)");
    }
    OutputFolder out(target, replayedLogs(), options.force);
    std::optional<CsvTable> replayed;
    out.collect([&](const std::filesystem::path& collected) {
        runAgain(loaded.scene, run, collected);
        replayed.emplace(readCsv(collected / run_files::kLog));
    });
    out.commit();
    compare(run, *replayed);
    tellOutcome(run);
}

}  // namespace

void addReplayCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "replay", "Replay a recorded run; check that every tick is bit-identical");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("RUN", options->run, "folder that explore or a recording wrote")
        ->required();
    addOutputFolder(*command, options->out, "folder for the replayed logs");
    addForce(*command, options->force);
    command->callback([options] { replay(*options); });
}

}  // namespace asperity
