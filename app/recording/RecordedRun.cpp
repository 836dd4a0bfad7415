#include "app/recording/RecordedRun.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/io/recording/PackedTables.h"
#include "core/io/recording/TickLog.h"
#include "core/io/scene/SceneFile.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace asperity {

namespace {

/// @throw InputError where there is none, or no JSON
nlohmann::json summaryOf(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / run_files::kSummary;
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        throw InputError(folder.string(), "",
                         "holds no run: there is neither recording.json nor summary.json");
    }
    return requiredJson(path);
}

std::string hashIn(const nlohmann::json& summary, const std::filesystem::path& folder) {
    const nlohmann::json::json_pointer pointer("/input/sha256");
    if (!summary.contains(pointer) || !summary[pointer].is_string()) {
        throw InputError((folder / run_files::kSummary).string(), "input.sha256",
                         "expected the hash of the scan");
    }
    return summary[pointer].get<std::string>();
}

std::optional<Vector2> sizeIn(const nlohmann::json& summary) {
    const auto length = [&summary](const char* key) -> std::optional<double> {
        const nlohmann::json::json_pointer pointer(std::string("/input/") + key);
        const bool isThere = summary.is_object() && summary.contains(pointer);
        return isThere && summary[pointer].is_number()
                   ? std::optional(summary[pointer].get<double>())
                   : std::nullopt;
    };
    const std::optional<double> x = length("size_x_m");
    const std::optional<double> y = length("size_y_m");
    return x && y ? std::optional(Vector2(*x, *y)) : std::nullopt;
}

}  // namespace

TickMemory startMemory(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / run_files::kMemory;
    return std::filesystem::exists(file) ? readTickMemory(file) : TickMemory{};
}

ScanRecord scanRecord(const std::filesystem::path& folder) {
    const std::optional<RecordingManifest> manifest = readManifest(folder);
    if (manifest && manifest->size) {
        return {.sha256 = manifest->sha256, .size = manifest->size};
    }
    if (manifest) {  // of an earlier version; cut off, it has no summary
        return {.sha256 = manifest->sha256, .size = sizeIn(readJson(folder / run_files::kSummary))};
    }
    const nlohmann::json summary = summaryOf(folder);
    return {.sha256 = hashIn(summary, folder), .size = sizeIn(summary)};
}

RunState stateOf(const std::filesystem::path& folder) {
    if (isGrowing(folder / run_files::kInput)) {
        return RunState::Recording;
    }
    const std::optional<RecordingManifest> manifest = readManifest(folder);
    if (manifest && !manifest->complete) {
        return RunState::Unfinished;
    }
    return manifest && manifest->recovered ? RunState::Recovered : RunState::Complete;
}

std::string sentenceOf(RunState state) {
    switch (state) {
    case RunState::Unfinished:
    case RunState::Recovered:
        return "the recording was cut off; it goes up to its last whole tick";
    case RunState::Recording:
        return "the recording is still being written; it goes up to its last whole tick so far";
    case RunState::Complete:
        break;
    }
    return {};
}

std::optional<RecordedSample> sampleOf(const std::filesystem::path& folder) {
    if (!isThere(folder / run_files::kScene)) {
        return std::nullopt;
    }
    try {
        const SampleDescription sample = sceneFromInput(folder / run_files::kScene).sample;
        return RecordedSample{.sha256 = scanRecord(folder).sha256,
                              .channel = sample.channel,
                              .crop = sample.crop,
                              .name = sampleName(sample)};
    } catch (const InputError&) {  // its tables may be all that is left of a run
        return std::nullopt;
    }
}

CsvTable readRunLog(const std::filesystem::path& file) {
    if (file.filename() == run_files::kTables) {
        return readPackedLog(file).rows;
    }
    return stateOf(file.parent_path()) == RunState::Complete ? readCsv(file)
                                                             : readUnfinishedCsv(file);
}

namespace {

RecordedRun readPackedRun(const std::filesystem::path& folder, RunState state) {
    const std::filesystem::path file = folder / run_files::kTables;
    PackedLog log = readPackedLog(file);
    return {.state = state,
            .scan = scanRecord(folder),
            .memory = startMemory(folder),
            .samples = readTickInputs(readPackedInput(file)),
            .log = std::move(log.rows),
            .logChecks = std::move(log.checks)};
}

}  // namespace

// The log is flushed before the input: where both are cut off, the input is mostly the shorter one.
RecordedRun readRun(const std::filesystem::path& folder) {
    const RunState state = stateOf(folder);
    if (!isThere(folder / run_files::kInput) && isThere(folder / run_files::kTables)) {
        return readPackedRun(folder, state);
    }
    const auto table = [&](const char* name) {
        const std::filesystem::path file = folder / name;
        if (state != RunState::Complete && std::filesystem::is_empty(file)) {
            throw InputError(file.string(), "", "the recording was cut off before its first tick");
        }
        return state == RunState::Complete ? readCsv(file) : readUnfinishedCsv(file);
    };
    RecordedRun run{.state = state,
                    .scan = scanRecord(folder),
                    .memory = startMemory(folder),
                    .samples = readTickInputs(table(run_files::kInput)),
                    .log = table(run_files::kLog)};
    if (state != RunState::Complete) {
        run.samples.resize(std::min(run.samples.size(), run.log.rows()));
    }
    return run;
}

}  // namespace asperity
