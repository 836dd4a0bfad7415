#pragma once

#include "core/Progress.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

namespace asperity {

/// Ends work that several threads share: each of them calls it some ten times a second.
class CancelCheck {
public:
    /// Of work that nothing cancels.
    CancelCheck() = default;
    /// @param asked may be null; is asked on this thread alone @param ended what all threads share;
    /// both must outlive this
    CancelCheck(const Progress* asked, std::atomic<bool>& ended) : asked_(asked), ended_(&ended) {}

    /// @throw Canceled as soon as the work is canceled, or has failed on another thread
    void operator()() const {
        if (asked_ != nullptr && asked_->isCanceled()) {
            *ended_ = true;
        }
        if (ended_ != nullptr && *ended_) {
            throw Canceled();
        }
    }

private:
    const Progress* asked_ = nullptr;
    std::atomic<bool>* ended_ = nullptr;
};

/// Waits for a share of the work that another thread does.
/// @throw what it threw; Canceled once it has ended after a cancellation
inline void waitFor(std::future<void>& share, const CancelCheck& check) {
    constexpr std::chrono::milliseconds kPause(20);
    while (share.wait_for(kPause) != std::future_status::ready) {
        check();
    }
    share.get();
}

/// Calls work(index, check) for 0..count - 1 on as many threads as the machine has cores. Work that
/// takes long calls `check`, a const CancelCheck&, now and then.
/// @param progress may be null; told and asked by the calling thread alone. @throw Canceled, what
/// work throws
template <class Work>
void shareOut(int count, Progress* progress, const Work& work) {
    constexpr int kReports = 50;
    std::atomic<int> next = 0;
    std::atomic<bool> ended = false;
    const auto run = [&](Progress* told) {
        const CancelCheck check(told, ended);
        for (int index = next++; index < count; index = next++) {
            check();
            if (told != nullptr && index % (count / kReports + 1) == 0) {
                told->report(static_cast<double>(index) / count);
            }
            work(index, check);
        }
    };
    const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, count);
    std::vector<std::future<void>> others;
    for (int i = 1; i < threads; ++i) {
        others.push_back(std::async(std::launch::async, run, nullptr));
    }
    try {
        run(progress);
        for (std::future<void>& other : others) {
            waitFor(other, CancelCheck(progress, ended));
        }
    } catch (...) {
        ended = true;  // the others end, too
        throw;
    }
}

}  // namespace asperity
