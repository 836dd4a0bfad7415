#include "app/session/LatestFile.h"

#include "core/TemporaryFile.h"

#include <exception>
#include <utility>

namespace asperity {

LatestFile::LatestFile(std::filesystem::path path)
    : path_(std::move(path)), thread_([this](const std::stop_token& stop) { work(stop); }) {}

void LatestFile::write(std::string text) {
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(text);
    }
    waiting_.notify_one();
}

std::string LatestFile::takeFailure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, {});
}

// A thread may not throw.
void LatestFile::work(const std::stop_token& stop) {
    for (;;) {
        std::unique_lock lock(mutex_);
        waiting_.wait(lock, stop, [this] { return next_.has_value(); });
        if (!next_) {
            return;
        }
        const std::string text = *std::exchange(next_, std::nullopt);
        lock.unlock();
        std::string failure;
        try {
            OutputFile file(path_);
            file.stream() << text;
            file.commitToDisk();
        } catch (const std::exception& error) {
            failure = error.what();
        }
        lock.lock();
        failure_ = failure;
    }
}

}  // namespace asperity
