#pragma once

#include <filesystem>

namespace asperity {

/// A new folder under the system's temporary one, for this user alone; removed with all that is in
/// it.
class PrivateFolder {
public:
    /// @throw Error when it cannot be made
    PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;
    ~PrivateFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace asperity
