#include "core/GrowingFile.h"

#include "core/Error.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <utility>

namespace asperity {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
    throw Error(path.string() + ": cannot be written: " + std::generic_category().message(errno));
}

}  // namespace

GrowingFile::GrowingFile(std::filesystem::path path)
    : path_(std::move(path))
    , file_(open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_APPEND | O_CLOEXEC,
                 0666)) {
    if (!file_.isOpen()) {
        fail(path_);
    }
    (void)file_.lock();  // a file system without locks is good enough to write on
}

GrowingFile::GrowingFile(std::filesystem::path path, std::uint64_t kept)
    : path_(std::move(path))
    , file_(open(path_.c_str(), O_WRONLY | O_NOFOLLOW | O_APPEND | O_CLOEXEC)) {
    if (!file_.isOpen()) {
        fail(path_);
    }
    if (!file_.lock() && errno == EWOULDBLOCK) {
        throw Error(path_.string() + ": another process is writing it");
    }
    if (ftruncate(file_.get(), static_cast<off_t>(kept)) != 0) {
        fail(path_);
    }
}

void GrowingFile::append(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(file_.get(), bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            fail(path_);
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
}

void GrowingFile::sync() const {
    if (fdatasync(file_.get()) != 0) {
        fail(path_);
    }
}

bool isGrowing(const std::filesystem::path& path) {
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
    return file.isOpen() && flock(file.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

void syncToDisk(const std::filesystem::path& path) noexcept {
    const FileDescriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.isOpen()) {
        (void)fsync(file.get());
    }
}

}  // namespace asperity
