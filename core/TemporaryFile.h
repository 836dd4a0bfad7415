#pragma once

#include "core/FileDescriptor.h"

#include <filesystem>
#include <fstream>

namespace asperity {

/// A file being written beside the one that it will replace, so that a write that fails half-way
/// leaves what was there before. Removed unless committed; what a killed process left for the same
/// target is removed by the next one. A symbolic link at the target stays, and what it leads to is
/// replaced.
///
/// Its own name is random, and it is created anew, so that no link planted in its place is
/// followed. Encoders that open path() themselves find the file there and truncate it.
class TemporaryFile {
public:
    /// @throw FileError when the target's folder cannot be written, or the target is there and no
    ///        regular file: a folder, a device, a pipe
    explicit TemporaryFile(std::filesystem::path target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] const std::filesystem::path& target() const noexcept { return target_; }

    /// Waits until the disk holds what was written. @throw Error
    void sync() const;
    /// Puts the written file in the target's place. @throw Error
    void commit() const;

private:
    [[nodiscard]] FileDescriptor created();

    std::filesystem::path target_;
    std::filesystem::path place_;  ///< of the target, links followed
    std::filesystem::path path_;
    FileDescriptor file_;  ///< holds the lock
};

/// Refuses a target that a TemporaryFile refuses, before long work is done for it. @throw FileError
void requireWritable(const std::filesystem::path& target);

/// A text or binary stream into a TemporaryFile.
class OutputFile {
public:
    /// @throw as TemporaryFile
    explicit OutputFile(std::filesystem::path target);

    [[nodiscard]] std::ostream& stream() noexcept { return stream_; }
    /// Flushes, checks that all was written, puts the file in place. @throw Error
    void commit();
    /// The same, and a power cut leaves the old file or the new one. @throw Error
    void commitToDisk();

private:
    void close();

    TemporaryFile file_;
    std::ofstream stream_;
};

}  // namespace asperity
