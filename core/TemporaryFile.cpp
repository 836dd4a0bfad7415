#include "core/TemporaryFile.h"

#include "core/Error.h"

#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity {

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), path_(target_) {
    path_ += ".part" + std::to_string(getpid());
    if (!std::ofstream(path_)) {
        throw Error(target_.string() +
                    ": cannot be written; its folder is missing or not writable");
    }
}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

void TemporaryFile::commit() const {
    std::error_code failure;
    std::filesystem::rename(path_, target_, failure);
    if (failure) {
        throw Error(target_.string() + ": cannot be put in place: " + failure.message());
    }
}

OutputFile::OutputFile(std::filesystem::path target)
    : file_(std::move(target)), stream_(file_.path(), std::ios::binary) {}

void OutputFile::commit() {
    stream_.close();
    if (!stream_) {
        throw Error(file_.target().string() + ": writing stopped half-way (disk full?)");
    }
    file_.commit();
}

}  // namespace asperity
