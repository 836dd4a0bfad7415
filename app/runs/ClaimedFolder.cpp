#include "app/runs/ClaimedFolder.h"

#include "core/Error.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <utility>

namespace asperity {

ClaimedFolder::ClaimedFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
    // An earlier owner may take an empty folder away between its making and its lock.
    constexpr int kTries = 100;
    for (int i = 0; i < kTries; ++i) {
        made_ = make() || made_;
        lock_ = FileDescriptor(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        if (lock_.isOpen() && !lock_.lock() && errno == EWOULDBLOCK) {
            throw Error(folder_.string() + ": something is being written into it");
        }
        std::error_code gone;
        const std::filesystem::path place = std::filesystem::canonical(folder_, gone);
        if (!lock_.isOpen() || lock_.isAt(place)) {
            return;
        }
    }
    throw Error(folder_.string() + ": the folder does not stay");
}

ClaimedFolder::~ClaimedFolder() {
    if (made_) {
        std::error_code ignored;
        std::filesystem::remove(folder_, ignored);  // only where it is empty
    }
}

bool ClaimedFolder::make() const {
    std::error_code failure;
    const bool made = std::filesystem::create_directories(folder_, failure);
    if (failure) {
        throw FileError(folder_.string(), "the folder cannot be made: " + failure.message());
    }
    return made;
}

}  // namespace asperity
