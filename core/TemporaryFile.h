#pragma once

#include "core/GrowingFile.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <sys/types.h>

namespace asperity {

/// A folder that exists only while something is written.
/// Removed with all that is in it; what killed processes left for the same purpose is removed by
/// the next one.
class TemporaryFolder {
public:
    /// @param parent  folder that it is made in
    /// @param purpose leftovers of the same one are deleted
    /// @param mode    permissions, less those that the umask takes away
    /// @throw FileError naming the parent where it cannot be made
    TemporaryFolder(const std::filesystem::path& parent, std::string_view purpose,
                    mode_t mode = 0777);
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

private:
    std::filesystem::path path_;
    FileDescriptor lock_{-1};
};

/// A file being written beside the one that it will replace, so that a write that fails half-way
/// leaves what was there before. Removed unless committed; what a killed process left for the same
/// target is removed by the next one. A symbolic link at the target stays, and what it leads to is
/// replaced.
///
/// Its own name is random, and it is newly created, so that no link planted in its place is
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
    std::filesystem::path location_;  ///< of the target, links followed
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

/// A new folder under the system's temporary one, for this user alone; removed with all that is in
/// it.
class PrivateFolder {
public:
    /// @throw FileError when it cannot be made
    PrivateFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
};

/// Files and folders that exist only while something is written have names that nobody can guess:
/// ".asperity-", a hash of what they are for, 16 random digits, ".part". Whoever writes one holds
/// its lock; one without a holder is a leftover of a process that was killed.

/// Start of the names of what is written for this file name, however long that is (the name of a
/// temporary file must not exceed NAME_MAX either). What is written for a file that has a
/// temporary name itself shares that one's start, so that both are swept for the same target.
[[nodiscard]] std::string temporaryPrefix(std::string_view purpose);
/// A new random name.
[[nodiscard]] std::string temporaryName(const std::string& prefix);

/// Locks what this process has just made. @return false: a sweeper was faster and deleted it
[[nodiscard]] bool holdTemporary(const FileDescriptor& made, const std::filesystem::path& path);

/// Removes leftovers: regular files and folders of the user's own with a name of this prefix that
/// no process holds. What cannot be looked at stays.
void sweepLeftovers(const std::filesystem::path& folder, const std::string& prefix);

}  // namespace asperity
