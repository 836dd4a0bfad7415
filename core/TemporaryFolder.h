#pragma once

#include "core/FileDescriptor.h"

#include <filesystem>
#include <string_view>
#include <sys/types.h>

namespace asperity {

/// A folder that exists only while something is written, as Leftover.h has it. Removed with all
/// that is in it; what killed processes left for the same purpose is removed by the next one.
class TemporaryFolder {
public:
    /// @param parent  folder that it is made in
    /// @param purpose leftovers of the same one go
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

}  // namespace asperity
