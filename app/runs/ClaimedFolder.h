#pragma once

#include "core/FileDescriptor.h"

#include <filesystem>

namespace asperity {

/// A folder that one writer has to itself, made where there is none: two of them at one moment
/// would take each other's files. File systems without locks grant every claim.
class ClaimedFolder {
public:
    /// @throw FileError where it cannot be made, Error where something writes into it
    explicit ClaimedFolder(std::filesystem::path folder);
    /// Without keep(), a folder that it made goes, while nothing is in it.
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

}  // namespace asperity
