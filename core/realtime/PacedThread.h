#pragma once

#include "core/EnumTable.h"

#include <atomic>
#include <functional>
#include <thread>

namespace asperity {

/// How the system schedules a thread.
enum class SchedulingPolicy : int {
    Realtime,  ///< SCHED_FIFO
    Ordinary,  ///< not allowed to be real-time: shares the processor with everything else
};

template <>
inline constexpr auto kEnumTable<SchedulingPolicy> = std::to_array<EnumRow<SchedulingPolicy>>(
    {{SchedulingPolicy::Realtime, "real-time"}, {SchedulingPolicy::Ordinary, "ordinary"}});

/// One period of a paced thread as its body sees it.
struct Beat {
    double lateness = 0.0;  ///< how long after its due time it begins [s]
    long skipped = 0;       ///< due times before this one that were missed altogether
    SchedulingPolicy policy = SchedulingPolicy::Ordinary;
};

/// Calls a function at a fixed rate on a thread of its own, SCHED_FIFO where that is allowed.
/// Sleeps to an absolute time and spins the last 40 microseconds, at most a quarter of a period.
/// Periods that were missed are skipped and counted, never caught up with.
class PacedThread {
public:
    using Body = std::function<void(const Beat&)>;

    /// Starts at once. `body` runs on the new thread and must not throw. @throw Error when there
    /// can be no more threads
    PacedThread(double rate, Body body);
    /// Lets the present period end, then stops.
    ~PacedThread();
    PacedThread(const PacedThread&) = delete;
    PacedThread& operator=(const PacedThread&) = delete;

private:
    void run() const;

    double period_;  ///< [s]
    Body body_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

/// Monotonic time, for measuring how long something takes [s].
[[nodiscard]] double monotonicSeconds() noexcept;

/// What the calling thread has taken of a processor [s].
[[nodiscard]] double processorSeconds() noexcept;

}  // namespace asperity
