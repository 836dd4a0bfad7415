#include "app/runs/BeginningRun.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/GrowingFile.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// The files of a run that are there.
std::vector<std::string> runIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    std::ranges::copy_if(runFileNames(), std::back_inserter(names),
                         [&](const std::string& name) { return isThere(folder / name); });
    return names;
}

/// Makes a folder for what is set aside; one that is there holds the run of a killed process.
std::filesystem::path madeAside(const std::filesystem::path& folder) {
    std::filesystem::path aside = folder / "replaced_run";
    for (int i = 2; !std::filesystem::create_directory(aside); ++i) {
        aside = folder / ("replaced_run_" + std::to_string(i));
    }
    return aside;
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
    : folder_(std::move(folder)) {
    requireFreeForRun(this->folder(), replace);
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
        std::filesystem::remove(folder() / name, ignored);
    }
    putBack();
}

void BeginningRun::setAside() {
    const std::vector<std::string> names = runIn(folder());
    if (names.empty()) {
        return;
    }
    try {
        aside_ = madeAside(folder());
        for (const std::string& name : names) {
            std::filesystem::rename(folder() / name, aside_ / name);
        }
    } catch (const std::filesystem::filesystem_error& error) {
        throw Error(folder().string() +
                    ": the earlier run cannot be replaced: " + error.code().message());
    }
}

void BeginningRun::putBack() noexcept {
    if (aside_.empty()) {
        return;
    }
    std::error_code ignored;
    for (const std::string& name : runIn(aside_)) {
        std::filesystem::rename(aside_ / name, folder() / name, ignored);
    }
    std::filesystem::remove(aside_, ignored);  // only where it is empty
}

void BeginningRun::keep() noexcept {
    kept_ = true;
    folder_.keep();
    if (!aside_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(aside_, ignored);
    }
}

}  // namespace asperity
