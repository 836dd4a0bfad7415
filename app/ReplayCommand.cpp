#include "app/ReplayCommand.h"

#include "app/LoadedScene.h"
#include "app/OptionChecks.h"
#include "app/ProgressLine.h"
#include "app/RunFolder.h"
#include "core/Error.h"
#include "core/haptics/HapticTick.h"
#include "core/io/CsvTable.h"
#include "core/io/TextValue.h"
#include "core/io/TickMemoryFile.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace asperity {

namespace {

struct ReplayOptions {
    std::string run;
    std::string out;
};

/// The hash of the scan that the run was made on.
std::string recordedHash(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / run_files::kSummary;
    std::ifstream file(path);
    const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
    const nlohmann::json::json_pointer pointer("/input/sha256");
    if (summary.is_discarded() || !summary.contains(pointer) || !summary[pointer].is_string()) {
        throw InputError(path.string(), "input.sha256", "expected the hash of the scan");
    }
    return summary[pointer].get<std::string>();
}

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

/// What the first tick starts from: a recording may begin in the middle of a run.
TickMemory startMemory(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / run_files::kMemory;
    return std::filesystem::exists(file) ? readTickMemory(file) : TickMemory{};
}

/// Runs the recorded inputs through the tick again and writes what comes out.
void runAgain(const Scene& scene, const std::filesystem::path& from,
              const std::filesystem::path& out) {
    std::vector<TickSample> samples = readTickInputs(from / run_files::kInput);
    if (!samples.empty()) {
        requireSameSettings(scene, samples);
    }
    RunRecorder recorder(out);
    TickMemory memory = startMemory(from);
    for (TickSample& sample : samples) {
        sample.output = tick(scene, sample.input, memory);
        recorder.take(sample);
    }
    recorder.close();
}

/// Compares two force logs cell by cell, as text: the numbers are written to the last bit.
/// @throw Error naming the first tick that differs
void compare(const CsvTable& recorded, const CsvTable& replayed) {
    const std::size_t common = std::min(recorded.rows(), replayed.rows());
    for (std::size_t row = 0; row < common; ++row) {
        for (const std::string& column : replayed.columns()) {
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
    if (recorded.rows() != replayed.rows()) {
        throw Error("first differing tick: " + std::to_string(common) + ": the recorded log has " +
                    std::to_string(recorded.rows()) + " ticks, the recorded input " +
                    std::to_string(replayed.rows()));
    }
}

void replay(const ReplayOptions& options) {
    const std::filesystem::path folder = options.run;
    const std::filesystem::path out = options.out;
    if (std::filesystem::exists(out) && std::filesystem::equivalent(folder, out)) {
        throw Error("--out must be another folder than the run: its logs would be overwritten");
    }
    const CsvTable recorded = readCsv(folder / run_files::kLog);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    if (loaded.sha256 != recordedHash(folder)) {
        throw InputError(loaded.scene.description.sample.file, "",
                         "the scan has changed since the run was recorded (its hash differs)");
    }
    makeOutputFolder(out);
    runAgain(loaded.scene, folder, out);
    compare(recorded, readCsv(out / run_files::kLog));
    std::cout << "bit-identical: " << recorded.rows() << " ticks\n";
}

}  // namespace

void addReplayCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "replay", "Run a recorded input again; say whether every tick is bit-identical");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("RUN", options->run, "folder that explore wrote")->required();
    addOutputFolder(*command, options->out, "folder for the replayed logs");
    command->callback([options] { replay(*options); });
}

}  // namespace asperity
