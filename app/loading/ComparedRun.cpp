#include "app/loading/ComparedRun.h"

#include "app/loading/SceneLoader.h"
#include "app/recording/Bundle.h"
#include "app/recording/Replay.h"
#include "app/runs/RunFolder.h"
#include "core/PrintableText.h"

namespace asperity {

namespace {

/// @param count names of folders, from the last one on
std::string lastNames(const std::filesystem::path& run, int count) {
    std::filesystem::path rest = std::filesystem::absolute(run).lexically_normal();
    if (!rest.has_filename()) {
        rest = rest.parent_path();
    }
    std::filesystem::path names = rest.filename();
    for (int i = 1; i < count; ++i) {
        rest = rest.parent_path();
        names = rest.filename() / names;
    }
    return printable(names.string());
}

}  // namespace

ComparedRun readComparedRun(const std::filesystem::path& input, Progress* progress) {
    constexpr double kLoaded = 0.3;  // about the share of the time
    const RunLocation named(input);
    ProgressPart loading(progress, 0.0, kLoaded);
    ProgressPart running(progress, kLoaded, 1.0);
    RunWithScene read = named.read([&] { return readRunWithScene(named.folder(), &loading); });
    RunPlayback playback(read.loaded.scene, std::move(read.run.inputs));
    return {.note = std::move(read.note),
            .conditions = conditionsOf(read.loaded),
            .trace = surveyOf(playback, &running).trace};
}

std::string runName(const std::filesystem::path& run) { return lastNames(run, 1); }

std::pair<std::string, std::string> runNames(const std::filesystem::path& first,
                                             const std::filesystem::path& second) {
    constexpr int kMax = 3;
    int count = 1;
    while (count < kMax && lastNames(first, count) == lastNames(second, count)) {
        ++count;
    }
    return {lastNames(first, count), lastNames(second, count)};
}

RunWithScene readRunWithScene(const std::filesystem::path& folder, Progress* progress) {
    RunOnDisk run = readRunInputs(folder);
    LoadedScene loaded = loadScene(folder / run_files::kScene, {}, progress);
    requireSameScan(loaded, run.scan);
    std::string note = sentenceOf(run.state);
    if (const std::string correction = correctionOfScan(loaded, run.scan); !correction.empty()) {
        note += (note.empty() ? "" : "; ") + correction;
    }
    return {.loaded = std::move(loaded), .run = std::move(run), .note = std::move(note)};
}

}  // namespace asperity
