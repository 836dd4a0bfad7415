#include "app/reports/RunFolder.h"

#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/Leftover.h"
#include "core/TemporaryFile.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

namespace asperity {

const std::vector<std::string>& runFileNames() {
    static const std::vector<std::string> kNames{
        run_files::kInput,    run_files::kScene,       run_files::kManifest,
        run_files::kMemory,   run_files::kLog,         run_files::kEnergy,
        run_files::kSummary,  run_files::kDeformation, run_files::kDeformationFields,
        run_files::kOverview, run_files::kForces};
    return kNames;
}

FolderContent exploredRun() {
    return {.own = runFileNames(), .guarded = {run_files::kManifest, run_files::kMemory}};
}

FolderContent replayedLogs() {
    FolderContent content{.own = {run_files::kInput, run_files::kLog}, .guarded = runFileNames()};
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

namespace {

bool isThere(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::exists(std::filesystem::symlink_status(path, unknown));
}

/// The files of a run that are there.
std::vector<std::string> runIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::ranges::copy_if(runFileNames(), std::back_inserter(names),
                         [&](const std::string& name) { return isThere(folder / name); });
    return names;
}

}  // namespace

void requireFreeForRun(const std::filesystem::path& folder, bool replace) {
    if (isGrowing(folder / run_files::kInput)) {
        throw Error(folder.string() + ": it is being recorded there");
    }
    const std::vector<std::string> names = runIn(folder);
    if (!replace && !names.empty()) {
        throw Error(folder.string() + ": there is a run in it already (" + names.front() +
                    "); name another folder, or replace that run with --force");
    }
}

BeginningRun::BeginningRun(std::filesystem::path folder, bool replace)
    : folder_(std::move(folder)), made_(!isThere(folder_)) {
    requireFreeForRun(folder_, replace);
    makeOutputFolder(folder_);
    try {
        setAside();
    } catch (...) {
        putBack();
        throw;
    }
}

BeginningRun::~BeginningRun() {
    if (kept_) {
        return;
    }
    std::error_code ignored;
    for (const std::string& name : runFileNames()) {
        std::filesystem::remove(folder_ / name, ignored);
    }
    putBack();
}

void BeginningRun::setAside() {
    const std::vector<std::string> names = runIn(folder_);
    if (names.empty()) {
        return;
    }
    // A prefix of its own: no command sweeps away what a killed one had set aside.
    aside_ = folder_ / temporaryName(temporaryPrefix("replaced run"));
    std::error_code failure;
    std::filesystem::create_directory(aside_, failure);
    for (const std::string& name : names) {
        if (!failure) {
            std::filesystem::rename(folder_ / name, aside_ / name, failure);
        }
        if (failure) {
            throw Error((folder_ / name).string() +
                        ": the earlier run's file cannot be replaced: " + failure.message());
        }
    }
}

void BeginningRun::putBack() noexcept {
    std::error_code ignored;
    if (!aside_.empty()) {
        for (const std::string& name : runIn(aside_)) {
            std::filesystem::rename(aside_ / name, folder_ / name, ignored);
        }
        std::filesystem::remove(aside_, ignored);  // only where it is empty
    }
    if (made_) {
        std::filesystem::remove(folder_, ignored);  // likewise
    }
}

void BeginningRun::keep() noexcept {
    kept_ = true;
    if (!aside_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(aside_, ignored);
    }
}

void writeTextFile(const std::filesystem::path& path, const std::string& text) {
    OutputFile file(path);
    file.stream() << text;
    file.commit();
}

}  // namespace asperity
