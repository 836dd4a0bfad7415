#include "core/TemporaryFile.h"

#include "core/Error.h"
#include "core/Leftover.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

std::string reasonOf(int error) { return std::generic_category().message(error); }

/// Where a file of this name is to be, symbolic links followed. @throw FileError when it cannot
/// be there
std::filesystem::path placeOf(const std::filesystem::path& target) {
    std::error_code failure;
    const std::filesystem::file_type kind = std::filesystem::status(target, failure).type();
    if (kind == std::filesystem::file_type::not_found) {
        return std::filesystem::is_symlink(std::filesystem::symlink_status(target, failure))
                   ? placeOf(target.parent_path() / std::filesystem::read_symlink(target))
                   : target;
    }
    if (failure) {
        throw FileError(target.string(), "cannot be written: " + failure.message());
    }
    if (kind != std::filesystem::file_type::regular) {
        throw FileError(target.string(), "cannot be written: it is there and no regular file");
    }
    return std::filesystem::canonical(target);
}

/// Whoever writes the file opens it once more, and would take the refusal for a full disk.
bool canOpenAnother(const FileDescriptor& file) {
    return FileDescriptor(fcntl(file.get(), F_DUPFD_CLOEXEC, 0)).isOpen();
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), place_(placeOf(target_)), file_(created()) {}

/// Names the file and creates it; what was left for the same target goes before.
FileDescriptor TemporaryFile::created() {
    constexpr mode_t kAsUmaskSays = 0666;
    constexpr int kTries = 100;
    const std::string prefix = temporaryPrefix(place_.filename().string());
    sweepLeftovers(place_.parent_path(), prefix);
    for (int i = 0; i < kTries; ++i) {
        path_ = place_.parent_path() / temporaryName(prefix);
        FileDescriptor file(open(
            path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kAsUmaskSays));
        if (file.isOpen() && !canOpenAnother(file)) {
            std::error_code ignored;
            std::filesystem::remove(path_, ignored);
            throw FileError(target_.string(), "cannot be written: " + reasonOf(EMFILE));
        }
        if (file.isOpen() && holdTemporary(file, path_)) {
            return file;
        }
        if (!file.isOpen() && errno != EEXIST) {
            break;
        }
    }
    throw FileError(target_.string(),
                    "cannot be written: " +
                        (errno == ENOENT ? "its folder is missing" : reasonOf(errno)));
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void TemporaryFile::sync() const {
    if (fsync(file_.get()) != 0) {
        throw Error(target_.string() + ": cannot be written: " + reasonOf(errno));
    }
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

void OutputFile::close() {
    stream_.close();
    if (!stream_) {
        throw Error(file_.target().string() + ": writing stopped half-way (disk full?)");
    }
}

void OutputFile::commit() {
    close();
    file_.commit();
}

void OutputFile::commitToDisk() {
    close();
    file_.sync();
    file_.commit();
}

}  // namespace asperity
