#include "core/TemporaryFolder.h"

#include "core/Error.h"
#include "core/Leftover.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>

namespace asperity {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& parent, std::string_view purpose,
                                 mode_t mode) {
    const std::string prefix = temporaryPrefix(purpose);
    sweepLeftovers(parent, prefix);
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        path_ = parent / temporaryName(prefix);
        if (mkdir(path_.c_str(), mode) != 0) {
            if (errno == EEXIST) {
                continue;
            }
            break;
        }
        lock_ =
            FileDescriptor(open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (lock_.isOpen() && holdTemporary(lock_, path_)) {
            return;
        }
        if (!lock_.isOpen()) {
            const int failure = errno;
            rmdir(path_.c_str());
            errno = failure;
            break;
        }
    }
    const std::string reason = std::generic_category().message(errno);
    throw FileError(parent.string(), "cannot be written: " + reason);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace asperity
