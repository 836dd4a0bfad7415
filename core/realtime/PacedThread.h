#pragma once

#include "core/EnumTable.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

namespace asperity {

/// Scheduling of a thread by the system.
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

/// Returns the processor time that the calling thread has used [s].
[[nodiscard]] double processorSeconds() noexcept;

/// Quantiles of a distribution of times.
struct LatencyQuantiles {
    double median = 0.0;   ///< [s]
    double p99 = 0.0;      ///< [s]
    double largest = 0.0;  ///< [s]
};

/// Counts times in steps of a sixteenth of their size, from 1 ns to 17 s, without allocating.
class LatencyHistogram {
public:
    /// A time [s]; those below zero count as zero.
    void add(double seconds) noexcept;
    /// All times of another one.
    void add(const LatencyHistogram& other) noexcept;
    void clear() noexcept { *this = {}; }

    [[nodiscard]] std::uint64_t count() const noexcept { return count_; }
    /// The time that a share of all times does not exceed, rounded up to the step [s]; 0 when
    /// nothing was counted.
    [[nodiscard]] double quantile(double share) const noexcept;
    [[nodiscard]] LatencyQuantiles quantiles() const noexcept;

private:
    static constexpr int kStepBits = 4;
    static constexpr int kOctaves = 34;
    static constexpr int kBuckets = (kOctaves - kStepBits + 1) << kStepBits;

    [[nodiscard]] static int bucketOf(std::uint64_t nanoseconds) noexcept;
    [[nodiscard]] static double upperEdge(int bucket) noexcept;  ///< [s]

    std::array<std::uint32_t, kBuckets> counts_{};
    std::uint64_t count_ = 0;
    double largest_ = 0.0;  ///< [s]
};

}  // namespace asperity
