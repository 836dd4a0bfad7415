#include "core/TemporaryFile.h"

#include "core/Error.h"

#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity {

namespace {

/// Where a file of this name is to be, symbolic links followed. @throw Error when it cannot be
/// there
std::filesystem::path placeOf(const std::filesystem::path& target) {
    std::error_code failure;
    const std::filesystem::file_type kind = std::filesystem::status(target, failure).type();
    if (kind == std::filesystem::file_type::not_found) {
        return std::filesystem::is_symlink(std::filesystem::symlink_status(target, failure))
                   ? placeOf(target.parent_path() / std::filesystem::read_symlink(target))
                   : target;
    }
    if (failure) {
        throw Error(target.string() + ": cannot be written: " + failure.message());
    }
    if (kind != std::filesystem::file_type::regular) {
        throw Error(target.string() + ": cannot be written: it is there and no regular file");
    }
    return std::filesystem::canonical(target);
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), place_(placeOf(target_)), path_(place_) {
    path_ += ".part" + std::to_string(getpid());
    if (!std::ofstream(path_)) {
        throw Error(target_.string() +
                    ": cannot be written; its folder is missing or not writable");
    }
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void TemporaryFile::commit() const {
    std::error_code failure;
    std::filesystem::rename(path_, place_, failure);
    if (failure) {
        throw Error(target_.string() + ": cannot be put in place: " + failure.message());
    }
}

void requireWritable(const std::filesystem::path& target) { const TemporaryFile probe(target); }

OutputFile::OutputFile(std::filesystem::path target)
    : file_(std::move(target)), stream_(file_.path(), std::ios::binary) {}

void OutputFile::commit() {
    stream_.close();
    if (!stream_) {
        throw Error(file_.target().string() + ": writing stopped half-way (disk full?)");
    }
    file_.commit();
}

}  // namespace asperity
