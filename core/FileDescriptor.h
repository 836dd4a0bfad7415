#pragma once

#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace asperity {

/// An open file or folder, closed at the end of its scope; -1 when it could not be opened.
class FileDescriptor {
public:
    explicit FileDescriptor(int descriptor) noexcept : descriptor_(descriptor) {}
    FileDescriptor(FileDescriptor&& other) noexcept
        : descriptor_(std::exchange(other.descriptor_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }

    [[nodiscard]] int get() const noexcept { return descriptor_; }
    [[nodiscard]] bool isOpen() const noexcept { return descriptor_ >= 0; }

    /// Locks the file for this process until the descriptor is closed, by whatever end.
    /// @return false: another process holds it, or the file system has no locks (errno)
    [[nodiscard]] bool lock() const noexcept {
        return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    }

    /// Whether this is what the path leads to now.
    [[nodiscard]] bool isAt(const std::filesystem::path& path) const noexcept {
        struct stat own {};
        struct stat there {};
        return ::fstat(descriptor_, &own) == 0 && ::lstat(path.c_str(), &there) == 0 &&
               own.st_dev == there.st_dev && own.st_ino == there.st_ino;
    }

private:
    int descriptor_;
};

}  // namespace asperity
