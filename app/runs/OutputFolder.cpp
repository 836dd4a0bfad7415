#include "app/runs/OutputFolder.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/PrintableText.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace asperity {

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
        throw Error((folder_ / name).string() + ": cannot be put in place: " + failure.message());
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

}  // namespace asperity
