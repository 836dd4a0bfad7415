#pragma once

#include "tests/support/Sanitized.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace asperity::test {

/// What a window may compute in one go on an idle machine [s]; a sanitizer's own code takes two to
/// three times as long.
inline constexpr double kLongestBlock = kSanitized ? 0.3 : 0.1;
/// What it may take in one go with what it waits for: part of that may be another program's load.
inline constexpr double kLongestWait = 5.0 * kLongestBlock;

/// How long an event loop did not answer in one step of a test.
struct BlockedStretch {
    std::string step;
    double wall = 0.0;  ///< [s]
    /// What of it is the program's own: without the time that threads of this process were ready to
    /// run while others had the processors, and without what the hypervisor took [s]
    double own = 0.0;
    double processor = 0.0;  ///< of it: computed by the loop's own thread [s]
};

/// Asks the event loop of the thread that makes it for an answer, again and again, from a thread of
/// its own, and keeps the longest time without one for each step of a test. As others may have the
/// processors meanwhile, it takes off what the kernel says that this process waited for them.
class EventLoopWatchdog {
public:
    EventLoopWatchdog();
    ~EventLoopWatchdog();
    EventLoopWatchdog(const EventLoopWatchdog&) = delete;
    EventLoopWatchdog& operator=(const EventLoopWatchdog&) = delete;

    /// From now on stretches belong to this step; a new one begins its row, an old one goes on.
    void enter(const std::string& step);
    /// The longest stretch of each step so far, in their order. The loop must have answered since:
    /// let it run for a moment first.
    [[nodiscard]] std::vector<BlockedStretch> longest() const;
    /// kLongestBlock on the machine as slow as it was at the beginning or is now [s].
    [[nodiscard]] double longestBlock() const;

private:
    class Answer;

    void watch();
    /// @return whether to go on
    bool waitForAnswer();
    void keep(const BlockedStretch& stretch);

    double slowness_;                  ///< at the beginning, see machineSlowness()
    std::unique_ptr<Answer> answers_;  ///< lives in the watched thread
    int watchedThread_;                ///< its number in the kernel
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool answered_ = true;
    bool ending_ = false;
    std::string step_ = "start";
    std::vector<BlockedStretch> longest_;
    std::thread thread_;
};

/// Wall time, own time and processor time of each step in milliseconds, a line each.
[[nodiscard]] std::string tableOf(const std::vector<BlockedStretch>& stretches);

}  // namespace asperity::test
