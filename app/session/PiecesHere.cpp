#include "app/session/PiecesHere.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kLook(20);  // for a cancellation

struct Piece {
    std::mutex mutex;  ///< held while it is done: none is given up half-way
    std::condition_variable ended;
    std::function<void()> work;  ///< null: done, or given up
    std::exception_ptr failure;

    void perform() {
        const std::lock_guard lock(mutex);
        if (work) {
            try {
                work();
            } catch (...) {
                failure = std::current_exception();
            }
            work = nullptr;
            ended.notify_one();
        }
    }
};

}  // namespace

void PiecesHere::run(const std::function<void()>& piece, const Progress& progress) {
    const auto shared = std::make_shared<Piece>();
    shared->work = piece;
    later([shared] { shared->perform(); });
    std::unique_lock lock(shared->mutex);
    while (!shared->ended.wait_for(lock, kLook, [&] { return shared->work == nullptr; })) {
        if (progress.isCanceled()) {
            shared->work = nullptr;
            throw Canceled();
        }
    }
    if (shared->failure) {
        std::rethrow_exception(shared->failure);
    }
}

}  // namespace asperity
