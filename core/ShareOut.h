#pragma once

#include "core/Progress.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

namespace asperity {

/// Cores that this process may use, at least 1: a launcher such as mpirun binds its processes to
/// some of the machine's.
[[nodiscard]] int allowedCores() noexcept;

/// Reports to a Progress how much of the work that several threads share is done.
class ShareReport {
public:
    /// @param progress may be null; is used on this thread alone
    /// @param done pieces, of `count`; all must outlive this
    ShareReport(Progress* progress, const std::atomic<int>& done, int count)
        : progress_(progress), done_(done), count_(count) {}

    /// Reports what was not reported yet, in steps of 2 %.
    void operator()() {
        constexpr int kReports = 50;
        const double share = static_cast<double>(done_) / count_;
        if (progress_ != nullptr && share >= next_) {
            next_ = share + 1.0 / kReports;
            progress_->report(share);
        }
    }

private:
    Progress* progress_;
    const std::atomic<int>& done_;
    int count_;
    double next_ = 0.0;
};

/// Ends work that several threads share, and has its progress reported: each of them calls it some
/// ten times a second.
class CancelCheck {
public:
    /// Makes a check for work that nothing cancels.
    CancelCheck() = default;
    /// @param asked may be null; is asked on this thread alone @param ended what all threads share
    /// @param report of the thread that asks, else null; all must outlive this
    CancelCheck(const Progress* asked, std::atomic<bool>& ended, ShareReport* report)
        : asked_(asked), ended_(&ended), report_(report) {}

    /// @throw Canceled as soon as the work is canceled, or has failed on another thread
    void operator()() const {
        if (asked_ != nullptr && asked_->isCanceled()) {
            *ended_ = true;
        }
        if (ended_ != nullptr && *ended_) {
            throw Canceled();
        }
        if (report_ != nullptr) {
            (*report_)();
        }
    }

private:
    const Progress* asked_ = nullptr;
    std::atomic<bool>* ended_ = nullptr;
    ShareReport* report_ = nullptr;
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

/// Calls work(index, check) for 0..count - 1. Work that takes long calls `check`, a const
/// CancelCheck&, now and then.
/// @param progress may be null; used by the calling thread alone
/// @param most threads; 0: as many as the process may use cores
/// @throw Canceled, what work throws
template <class Work>
void shareOut(int count, Progress* progress, const Work& work, int most = 0) {
    std::atomic<int> next = 0;
    std::atomic<int> done = 0;
    std::atomic<bool> ended = false;
    ShareReport report(progress, done, count);
    const auto run = [&](const CancelCheck& check) {
        for (int index = next++; index < count; index = next++) {
            check();
            work(index, check);
            ++done;
        }
    };
    const int wanted = most > 0 ? most : allowedCores();
    const int threads = std::clamp(wanted, 1, count);
    std::vector<std::future<void>> others;
    for (int i = 1; i < threads; ++i) {
        others.push_back(std::async(std::launch::async, run, CancelCheck(nullptr, ended, nullptr)));
    }
    try {
        const CancelCheck check(progress, ended, &report);
        check();  // the others may leave no piece for this thread
        run(check);
        for (std::future<void>& other : others) {
            waitFor(other, check);
        }
        report();  // this thread may have come too late for any of it
    } catch (...) {
        ended = true;  // the others end, too
        throw;
    }
}

}  // namespace asperity
