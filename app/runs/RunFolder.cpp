#include "app/runs/RunFolder.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

std::vector<std::string> without(std::vector<std::string> names,
                                 const std::vector<std::string>& others) {
    std::erase_if(names, [&](const std::string& name) {
        return std::ranges::find(others, name) != others.end();
    });
    return names;
}

}  // namespace

const std::vector<std::string>& runFileNames() {
    static const std::vector<std::string> kNames{
        run_files::kInput,       run_files::kTables,
        run_files::kScene,       run_files::kManifest,
        run_files::kMemory,      run_files::kLog,
        run_files::kEnergy,      run_files::kSummary,
        run_files::kDeformation, run_files::kDeformationFields,
        run_files::kOverview,    run_files::kForces};
    return kNames;
}

FolderContent exploredRun() {
    const std::vector<std::string> marks{run_files::kInput, run_files::kTables};
    return {.marks = marks,
            .own = without(runFileNames(), marks),
            .guarded = {run_files::kManifest, run_files::kMemory},
            .needed = {run_files::kScene, run_files::kSummary}};
}

FolderContent convertedRun() {
    FolderContent content = exploredRun();
    content.guarded = runFileNames();
    return content;
}

FolderContent replayedLogs() {
    const std::vector<std::string> logs{run_files::kInput, run_files::kLog};
    return {
        .marks = {logs.front()}, .own = {logs.back()}, .guarded = without(runFileNames(), logs)};
}

RunRecorder::RunRecorder(const std::filesystem::path& folder,
                         std::shared_ptr<const MaterialField> field)
    : log_(folder / run_files::kLog, std::move(field)), input_(folder / run_files::kInput) {}

void RunRecorder::take(const TickSample& sample) {
    log_.take(sample);
    input_.take(sample);
}

void RunRecorder::flush() {
    log_.flush();
    input_.flush();
}

void RunRecorder::sync() const {
    log_.sync();
    input_.sync();
}

void RunRecorder::close() {
    log_.close();
    input_.close();
}

bool isThere(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(std::filesystem::symlink_status(path, unknown));
}

bool isSceneOfRun(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path();
    return file.filename() == run_files::kScene &&
           (isThere(folder / run_files::kInput) || isThere(folder / run_files::kTables));
}

void requireFree(const std::filesystem::path& file, bool force) {
    if (!force && isThere(file)) {
        throw Error(file.string() +
                    ": is there already; name another file, or replace it with --force");
    }
}

void requireOutside(const std::filesystem::path& input, const std::filesystem::path& file) {
    std::error_code unknown;
    const std::filesystem::path named = std::filesystem::absolute(file, unknown);
    for (std::filesystem::path place : {named, std::filesystem::weakly_canonical(named, unknown)}) {
        for (; place.has_relative_path(); place = place.parent_path()) {
            if (std::filesystem::equivalent(input, place, unknown)) {
                throw Error(file.string() + ": this is an input, or lies in the folder of one; "
                                            "name a file elsewhere");
            }
        }
    }
}

void writeTextFile(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace asperity
