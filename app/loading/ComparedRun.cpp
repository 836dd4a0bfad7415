#include "app/loading/ComparedRun.h"

#include "app/loading/RunWithScene.h"
#include "app/recording/RunPlace.h"
#include "app/recording/RunSurvey.h"
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
    const RunPlace place(input);
    ProgressPart loading(progress, 0.0, kLoaded);
    ProgressPart running(progress, kLoaded, 1.0);
    RunWithScene read = place.read([&] { return readRunWithScene(place.folder(), &loading); });
    RunPlayback playback(read.loaded.scene, std::move(read.run.inputs));
    return {.note = std::move(read.note),
            .conditions = conditionsOf(read.loaded),
            .trace = surveyOf(playback, &running).trace};
}

std::string runName(const std::filesystem::path& run) { return lastNames(run, 1); }

std::pair<std::string, std::string> runNames(const std::filesystem::path& first,
                                             const std::filesystem::path& second) {
    constexpr int kMost = 3;
    int count = 1;
    while (count < kMost && lastNames(first, count) == lastNames(second, count)) {
        ++count;
    }
    return {lastNames(first, count), lastNames(second, count)};
}

}  // namespace asperity
