#pragma once

#include "app/runs/ClaimedFolder.h"
#include "core/TemporaryFolder.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What a command leaves in a folder.
struct FolderContent {
    /// Those of its files that stand for the whole, one of them in each result, and have names that
    /// nobody else gives: without one, files with the names of the rest are taken for somebody's.
    std::vector<std::string> marks;
    std::vector<std::string> own;          ///< the rest of its files
    std::vector<std::string> guarded;      ///< files of others that it must not write over unasked
    std::vector<std::string> needed = {};  ///< files that stand beside a mark in each result
};

/// The folder that a command writes its files into. They are collected in a hidden folder within it
/// and come out together, by renaming, when all are complete: until then an earlier result stays as
/// it is. Then all of its files go, and those that are no files of the command stay. What stands
/// for the whole goes first and comes last, so that a mixture is never taken for a result. Staying
/// within the folder works where it is a mount point or a link, or its parent cannot be written.
class OutputFolder {
public:
    /// Makes the folder where there is none; what killed commands left in it goes.
    /// @param force guarded files may go
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

}  // namespace asperity
