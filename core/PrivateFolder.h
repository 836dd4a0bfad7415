#pragma once

#include "core/TemporaryFolder.h"

namespace asperity {

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

}  // namespace asperity
