#pragma once

#include <filesystem>
#include <fstream>

namespace asperity {

/// A file being written beside the one that it will replace, so that a write that fails half-way
/// leaves what was there before. Removed unless committed. A symbolic link stays, and what it leads
/// to is replaced.
class TemporaryFile {
public:
    /// @throw Error when the target's folder cannot be written, or the target is there and no
    ///        regular file: a folder, a device, a pipe
    explicit TemporaryFile(std::filesystem::path target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
    [[nodiscard]] const std::filesystem::path& target() const noexcept { return target_; }

    /// Puts the written file in the target's place. @throw Error
    void commit() const;

private:
    std::filesystem::path target_;
    std::filesystem::path place_;  ///< of the target, links followed
    std::filesystem::path path_;
};

/// Refuses a target that a TemporaryFile refuses, before long work is done for it. @throw Error
void requireWritable(const std::filesystem::path& target);

/// A text or binary stream into a TemporaryFile.
class OutputFile {
public:
    /// @throw as TemporaryFile
    explicit OutputFile(std::filesystem::path target);

    [[nodiscard]] std::ostream& stream() noexcept { return stream_; }
    /// Flushes, checks that all was written, puts the file in place. @throw Error
    void commit();

private:
    TemporaryFile file_;
    std::ofstream stream_;
};

}  // namespace asperity
