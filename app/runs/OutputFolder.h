#pragma once

#include "core/GrowingFile.h"
#include "core/TemporaryFile.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A folder that one writer has to itself, made where there is none: two of them at one moment
/// would take each other's files. File systems without locks grant every claim.
class ClaimedFolder {
public:
    /// @throw FileError where it cannot be made, Error where something writes into it
    explicit ClaimedFolder(std::filesystem::path folder);
    /// Without keep(), a folder that it made is deleted while empty.
    ~ClaimedFolder();
    ClaimedFolder(const ClaimedFolder&) = delete;
    ClaimedFolder& operator=(const ClaimedFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return folder_; }
    void keep() noexcept { made_ = false; }

private:
    [[nodiscard]] bool make() const;

    std::filesystem::path folder_;
    bool made_ = false;
    FileDescriptor lock_{-1};
};

/// Files that a command leaves in a folder.
struct FolderContent {
    /// Files that mark a whole result, one of them in each result, and have names that
    /// nobody else gives: without one, files with the names of the rest are taken for somebody's.
    std::vector<std::string> marks;
    std::vector<std::string> own;          ///< the rest of its files
    std::vector<std::string> guarded;      ///< files of others that it must not write over unasked
    std::vector<std::string> needed = {};  ///< files beside a mark in each result
};

/// The folder that a command writes its files into. They are collected in a hidden folder within it
/// and come out together, by renaming, when all are complete: until then an earlier result stays as
/// it is. Then all of its files are deleted, and other files stay. The mark of the
/// whole is deleted first and comes last, so that a mixture is never taken for a result. Staying
/// within the folder works where it is a mount point or a link, or its parent cannot be written.
class OutputFolder {
public:
    /// Makes the folder where there is none; deletes what killed commands left in it.
    /// @param force guarded files may be deleted
    /// @throw Error where there are guarded files, FileError where the folder cannot be written
    OutputFolder(std::filesystem::path folder, FolderContent content, bool force = false);
    /// Without commit() all is as before.
    ~OutputFolder() = default;
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Has the files written where they are collected; may be called again for more of them.
    /// @throw what `write` throws; an Error names the folder, not where they are collected
    void collect(const std::function<void(const std::filesystem::path& folder)>& write) const;
    /// Puts the files in place. @throw Error
    void commit();

private:
    void requireNoFolder(const std::string& name) const;
    void requireAllowed() const;
    void remove(const std::filesystem::path& name) const;
    void moveOut(const std::filesystem::path& name) const;

    ClaimedFolder claim_;
    const std::filesystem::path& folder_;
    FolderContent content_;
    bool force_;
    std::optional<TemporaryFolder> staging_;
};

/// Refuses what an OutputFolder refuses, before long work is done for it, and leaves nothing.
/// @throw as OutputFolder
void requireOutputFolder(const std::filesystem::path& folder, const FolderContent& content,
                         bool force);

/// A recording is written into its folder from its first tick on, so the folder must not hold a run
/// yet, but for one that may be replaced. Changes nothing.
/// @throw Error where it does, or a recording is running there
void requireFreeForRun(const std::filesystem::path& folder, bool replace);

/// The folder of a run that begins. What an earlier run left is set aside, in the folder
/// replaced_run within it; without keep() all is as before: the new run's files are deleted, what
/// was set aside comes back. Killed in these milliseconds, a process leaves it there.
class PendingRunFolder {
public:
    /// Makes the folder where there is none.
    /// @param replace deletes the files of an earlier run @throw Error as requireFreeForRun(), or
    /// when the folder cannot be written
    PendingRunFolder(std::filesystem::path folder, bool replace);
    ~PendingRunFolder();
    PendingRunFolder(const PendingRunFolder&) = delete;
    PendingRunFolder& operator=(const PendingRunFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_.path(); }
    /// The new run is there: deletes what was set aside.
    void keep() noexcept;

private:
    void setAside();
    void putBack() noexcept;

    ClaimedFolder folder_;
    std::filesystem::path aside_;  ///< empty: nothing was there
    bool kept_ = false;
};

}  // namespace asperity
