#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
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

    /// Returns whether the path leads to this file now.
    [[nodiscard]] bool isAt(const std::filesystem::path& path) const noexcept {
        struct stat own {};
        struct stat there {};
        return ::fstat(descriptor_, &own) == 0 && ::lstat(path.c_str(), &there) == 0 &&
               own.st_dev == there.st_dev && own.st_ino == there.st_ino;
    }

private:
    int descriptor_;
};

/// A file that grows in its final place, new or with what an earlier one left: what was appended
/// stays, whatever ends the program. While it is open it is locked, so that others can see whether
/// somebody still writes it.
class GrowingFile {
public:
    /// @throw Error when it cannot be made, or there is something of this name
    explicit GrowingFile(std::filesystem::path path);
    /// Opens an existing file to append after its first `kept` bytes; the rest is deleted.
    /// @throw Error when it cannot be opened, or another process holds it open
    GrowingFile(std::filesystem::path path, std::uint64_t kept);

    /// Passes all of it to the system: a killed process loses nothing of it.
    /// @throw Error with the system's reason, such as a full disk; a part may be written
    void append(std::string_view bytes);
    /// Waits until the disk holds what was appended: a power cut loses nothing of it. @throw Error
    void sync() const;

private:
    std::filesystem::path path_;
    FileDescriptor file_;
};

/// Returns whether some process holds a GrowingFile of this path open.
[[nodiscard]] bool isGrowing(const std::filesystem::path& path);

/// Waits until the disk holds a file or a folder's list of files; in good faith, no promise.
void syncToDisk(const std::filesystem::path& path) noexcept;

}  // namespace asperity
