#include "app/runs/OutputFolder.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/PrintableText.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <iterator>
#include <system_error>
#include <utility>

namespace asperity {

ClaimedFolder::ClaimedFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
    // An earlier owner may take an empty folder away between its making and its lock.
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        made_ = make() || made_;
        lock_ = FileDescriptor(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (lock_.isOpen() && !lock_.lock() && errno == EWOULDBLOCK) {
            throw Error(folder_.string() + ": something is being written into it");
        }
        std::error_code gone;
        const std::filesystem::path found = std::filesystem::canonical(folder_, gone);
        if (!lock_.isOpen() || lock_.isAt(found)) {
            return;
        }
    }
    throw Error(folder_.string() + ": the folder does not stay");
}

ClaimedFolder::~ClaimedFolder() {
    if (made_) {
        std::error_code ignored;
        std::filesystem::remove(folder_, ignored);  // only where it is empty
    }
}

bool ClaimedFolder::make() const {
    std::error_code failure;
    const bool made = std::filesystem::create_directories(folder_, failure);
    if (failure) {
        throw FileError(folder_.string(), "the folder cannot be made: " + failure.message());
    }
    return made;
}

OutputFolder::OutputFolder(std::filesystem::path folder, FolderContent content, bool force)
    : claim_(std::move(folder))
    , folder_(claim_.path())
    , content_(std::move(content))
    , force_(force) {
    requireAllowed();
    staging_.emplace(folder_, "results");
}

void OutputFolder::requireNoFolder(const std::string& name) const {
    std::error_code unknown;
    if (std::filesystem::is_directory(folder_ / name, unknown)) {
        throw FileError((folder_ / name).string(), "cannot be written: it is there and a folder");
    }
}

void OutputFolder::requireAllowed() const {
    for (const auto* names : {&content_.marks, &content_.own}) {
        std::ranges::for_each(*names, [this](const std::string& name) { requireNoFolder(name); });
    }
    if (isGrowing(folder_ / run_files::kInput)) {
        throw Error(folder_.string() + ": it is being recorded there");
    }
    const auto isIn = [this](const std::string& name) { return isThere(folder_ / name); };
    const bool isOurs =
        std::ranges::any_of(content_.marks, isIn) && std::ranges::all_of(content_.needed, isIn);
    for (const auto* names : {&content_.marks, &content_.own}) {
        const auto other = std::ranges::find_if(*names, isIn);
        if (!force_ && !isOurs && other != names->end()) {
            throw Error((folder_ / *other).string() +
                        ": is not of a whole earlier run of this command; name another folder, or "
                        "replace that file with --force");
        }
    }
    for (const std::string& name : content_.guarded) {
        if (!force_ && isThere(folder_ / name)) {
            throw Error(folder_.string() + ": there is a recording or another run in it (" + name +
                        "); name another folder, or replace that run with --force");
        }
    }
}

void OutputFolder::remove(const std::filesystem::path& name) const {
    std::error_code failure;
    std::filesystem::remove(folder_ / name, failure);
    if (failure) {
        throw Error((folder_ / name).string() +
                    ": the earlier run's file cannot be removed: " + failure.message());
    }
}

void OutputFolder::moveOut(const std::filesystem::path& name) const {
    std::error_code failure;
    std::filesystem::rename(staging_->path() / name, folder_ / name, failure);
    if (failure) {
        throw Error((folder_ / name).string() + ": cannot be moved here: " + failure.message());
    }
}

void OutputFolder::collect(
    const std::function<void(const std::filesystem::path& folder)>& write) const {
    try {
        write(staging_->path());
    } catch (const Error& error) {
        const std::string hidden = printable(staging_->path().string());
        std::string message = error.what();
        const std::size_t at = message.find(hidden);
        if (at == std::string::npos) {
            throw;
        }
        throw Error(message.replace(at, hidden.size(), folder_.string()));
    }
}

void OutputFolder::commit() {
    requireAllowed();
    std::ranges::for_each(content_.marks, [this](const std::string& name) { remove(name); });
    for (const auto* names : {&content_.own, &content_.guarded}) {
        for (const std::string& name : *names) {
            if (!isThere(staging_->path() / name)) {
                remove(name);
            }
        }
    }
    for (const auto& file : std::filesystem::directory_iterator(staging_->path())) {
        const std::filesystem::path name = file.path().filename();
        if (std::ranges::find(content_.marks, name.string()) == content_.marks.end()) {
            moveOut(name);
        }
    }
    for (const std::string& name : content_.marks) {
        if (isThere(staging_->path() / name)) {
            moveOut(name);
        }
    }
    claim_.keep();
}

void requireOutputFolder(const std::filesystem::path& folder, const FolderContent& content,
                         bool force) {
    const OutputFolder probe(folder, content, force);
}

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

PendingRunFolder::PendingRunFolder(std::filesystem::path folder, bool replace)
    : folder_(std::move(folder)) {
    requireFreeForRun(this->folder(), replace);
    try {
        setAside();
    } catch (...) {
        putBack();
        throw;
    }
}

PendingRunFolder::~PendingRunFolder() {
    if (kept_) {
        return;
    }
    std::error_code ignored;
    for (const std::string& name : runFileNames()) {
        std::filesystem::remove(folder() / name, ignored);
    }
    putBack();
}

void PendingRunFolder::setAside() {
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

void PendingRunFolder::putBack() noexcept {
    if (aside_.empty()) {
        return;
    }
    std::error_code ignored;
    for (const std::string& name : runIn(aside_)) {
        std::filesystem::rename(aside_ / name, folder() / name, ignored);
    }
    std::filesystem::remove(aside_, ignored);  // only where it is empty
}

void PendingRunFolder::keep() noexcept {
    kept_ = true;
    folder_.keep();
    if (!aside_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(aside_, ignored);
    }
}

}  // namespace asperity
