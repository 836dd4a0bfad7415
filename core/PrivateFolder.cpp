#include "core/PrivateFolder.h"

#include "core/Error.h"

#include <system_error>

namespace asperity {

namespace {

constexpr mode_t kOwnerOnly = 0700;

std::filesystem::path parentFolder() {
    std::error_code failure;
    std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
    if (failure) {
        throw FileError(parent.empty() ? "TMPDIR" : parent.string(),
                        "there is no folder for temporary files; is TMPDIR right?");
    }
    return parent;
}

}  // namespace

PrivateFolder::PrivateFolder() : folder_(parentFolder(), "private", kOwnerOnly) {}

}  // namespace asperity
