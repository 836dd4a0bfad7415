#include "core/PrivateFolder.h"

#include "core/Error.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace asperity {

PrivateFolder::PrivateFolder() {
    std::error_code failure;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
    if (failure) {
        throw Error("there is no folder for temporary files; is TMPDIR right?");
    }
    std::string name = (parent / "asperity-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw Error("a folder for temporary files cannot be made in " + parent.string() + ": " +
                    std::generic_category().message(errno));
    }
    path_ = name;
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace asperity
