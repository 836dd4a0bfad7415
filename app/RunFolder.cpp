#include "app/RunFolder.h"

#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/TemporaryFile.h"

#include <system_error>

namespace asperity {

const std::vector<std::string>& runFileNames() {
    static const std::vector<std::string> kNames{
        run_files::kScene,    run_files::kManifest,    run_files::kInput,
        run_files::kMemory,   run_files::kLog,         run_files::kEnergy,
        run_files::kSummary,  run_files::kDeformation, run_files::kDeformationFields,
        run_files::kOverview, run_files::kForces};
    return kNames;
}

FolderContent exploredRun() {
    return {.own = runFileNames(), .guarded = {run_files::kManifest, run_files::kMemory}};
}

FolderContent replayedLogs() {
    FolderContent content{.own = {run_files::kLog, run_files::kInput}, .guarded = runFileNames()};
    std::erase(content.guarded, run_files::kLog);
    std::erase(content.guarded, run_files::kInput);
    return content;
}

RunRecorder::RunRecorder(const std::filesystem::path& folder)
    : log_(folder / run_files::kLog), input_(folder / run_files::kInput) {}

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

void makeOutputFolder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw Error(folder.string() + ": the folder cannot be made: " + failure.message());
    }
}

void requireNoRun(const std::filesystem::path& folder) {
    for (const std::string& name : runFileNames()) {
        std::error_code unknown;
        if (std::filesystem::exists(std::filesystem::symlink_status(folder / name, unknown))) {
            throw Error(folder.string() + ": there is a run in it already (" + name +
                        "); name another folder, or replace that run with --force");
        }
    }
}

void removeRun(const std::filesystem::path& folder) {
    if (isGrowing(folder / run_files::kInput)) {
        throw Error(folder.string() + ": it is being recorded there");
    }
    for (const std::string& name : runFileNames()) {
        std::error_code failure;
        std::filesystem::remove(folder / name, failure);
        if (failure) {
            throw Error((folder / name).string() +
                        ": the earlier run's file cannot be removed: " + failure.message());
        }
    }
}

void writeTextFile(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace asperity
