#pragma once

#include "core/FileDescriptor.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace asperity {

/// Files and folders that exist only while something is written have names that nobody can guess:
/// ".asperity-", a hash of what they are for, 16 random digits, ".part". Whoever writes one holds
/// its lock; one without a holder is a leftover of a process that was killed.

/// Start of the names of what is written for this file name, however long that is (the name of a
/// temporary file must not exceed NAME_MAX either). What is written for a file that has a
/// temporary name itself shares that one's start, so that both are swept for the same target.
[[nodiscard]] std::string temporaryPrefix(std::string_view purpose);
/// A new random name.
[[nodiscard]] std::string temporaryName(const std::string& prefix);

/// Locks what this process has just made. @return false: a sweeper was faster, and it is gone
[[nodiscard]] bool holdTemporary(const FileDescriptor& made, const std::filesystem::path& path);

/// Removes leftovers: regular files and folders of the user's own with a name of this prefix that
/// no process holds. What cannot be looked at stays.
void sweepLeftovers(const std::filesystem::path& folder, const std::string& prefix);

}  // namespace asperity
