#include "core/realtime/PacedThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace asperity {
namespace {

void waitFor(const std::atomic<long>& counter, long value) {
    while (counter.load() < value) {
        std::this_thread::yield();
    }
}

TEST(PacedThread, NeverBeatsBeforeItsTime) {
    std::atomic<long> beats{0};
    std::atomic<bool> early{false};
    const double begin = monotonicSeconds();
    {
        const PacedThread thread(2000.0, [&](const Beat& beat) {
            early = early || beat.lateness < 0.0;
            ++beats;
        });
        waitFor(beats, 200);
    }
    EXPECT_FALSE(early);
    EXPECT_GE(monotonicSeconds() - begin, 199 / 2000.0);
}

TEST(PacedThread, SkipsWhatItMissedAndKeepsItsPlace) {
    // What counts is the schedule: beats and skipped due times together never outrun the clock,
    // and a body that takes ten periods makes it skip about nine, not run nine times at once.
    constexpr double kPeriod = 1e-3;
    std::atomic<long> beats{0};
    std::atomic<long> skipped{0};
    std::atomic<double> first{0.0};
    std::atomic<double> last{0.0};
    {
        const PacedThread thread(1.0 / kPeriod, [&](const Beat& beat) {
            const double due = monotonicSeconds() - beat.lateness + beat.skipped * kPeriod;
            if (beats == 0) {
                first = due;
            }
            skipped += beats == 0 ? 0 : beat.skipped;
            last = due;
            if (beats == 5) {
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
            ++beats;
        });
        waitFor(beats, 20);
    }
    EXPECT_GE(skipped, 8);
    const double elapsed = (last - first) / kPeriod;
    EXPECT_NEAR(elapsed, static_cast<double>(beats - 1 + skipped), 0.5);
}

TEST(PacedThread, StopsForGood) {
    std::atomic<long> beats{0};
    std::optional<PacedThread> thread;
    thread.emplace(1000.0, [&](const Beat&) { ++beats; });
    waitFor(beats, 3);
    thread.reset();
    const long after = beats;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(beats, after);
}

TEST(PacedThread, SaysHowItIsScheduled) {
    std::atomic<long> beats{0};
    std::atomic<SchedulingPolicy> told{SchedulingPolicy::Ordinary};
    std::atomic<int> actual{-1};
    {
        const PacedThread thread(1000.0, [&](const Beat& beat) {
            told = beat.policy;
            int policy = 0;
            sched_param parameters{};
            pthread_getschedparam(pthread_self(), &policy, &parameters);
            actual = policy;
            ++beats;
        });
        waitFor(beats, 2);
    }
    EXPECT_EQ(told == SchedulingPolicy::Realtime, actual == SCHED_FIFO);
}

}  // namespace
}  // namespace asperity
