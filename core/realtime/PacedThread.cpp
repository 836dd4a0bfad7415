#include "core/realtime/PacedThread.h"

#include "core/Error.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <ctime>
#include <pthread.h>
#include <sys/prctl.h>
#include <system_error>

namespace asperity {

namespace {

constexpr int kPriority = 80;           // below the kernel's own threads, above everything of ours
constexpr double kSpin = 40e-6;         // a sleep wakes up late by about this much [s]
constexpr double kMaxSpinShare = 0.25;  // of a period: the rest of the machine must live
constexpr double kFirstBeat = 1e-3;     // after the thread has started [s]

/// Else the system lets an ordinary thread sleep up to 50 microseconds too long, more than it
/// spins.
void wakePunctually() {
    constexpr unsigned long kSlack = 1000;  // [ns]
    prctl(PR_SET_TIMERSLACK, kSlack);
}

SchedulingPolicy claimRealtime() {
    sched_param parameters{};
    parameters.sched_priority = kPriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0
               ? SchedulingPolicy::Realtime
               : SchedulingPolicy::Ordinary;
}

timespec toTimespec(double seconds) {
    const double whole = std::floor(seconds);
    return {.tv_sec = static_cast<time_t>(whole),
            .tv_nsec = static_cast<long>((seconds - whole) * 1e9)};
}

double secondsOf(clockid_t clock) noexcept {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// @param spin last part of the way that is not slept [s]
void waitUntil(double time, double spin) {
    const timespec wake = toTimespec(time - spin);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {
    }
    while (monotonicSeconds() < time) {
    }
}

}  // namespace

double monotonicSeconds() noexcept { return secondsOf(CLOCK_MONOTONIC); }

double processorSeconds() noexcept { return secondsOf(CLOCK_THREAD_CPUTIME_ID); }

PacedThread::PacedThread(double rate, Body body) : period_(1.0 / rate), body_(std::move(body)) {
    try {
        thread_ = std::thread([this] { run(); });
    } catch (const std::system_error& error) {
        throw Error(std::string("the loop's thread could not be started: ") + error.what());
    }
}

PacedThread::~PacedThread() {
    stop_.store(true, std::memory_order_relaxed);
    thread_.join();
}

void PacedThread::run() const {
    wakePunctually();
    Beat beat{.policy = claimRealtime()};
    const double spin = std::min(kSpin, kMaxSpinShare * period_);
    double due = monotonicSeconds() + kFirstBeat;
    while (!stop_.load(std::memory_order_relaxed)) {
        waitUntil(due, spin);
        beat.lateness = monotonicSeconds() - due;
        beat.skipped = static_cast<long>(beat.lateness / period_);
        due += static_cast<double>(beat.skipped) * period_;
        body_(beat);
        due += period_;
    }
}

// Times below 2^kStepBits ns have a bucket each; above, every octave has 2^kStepBits of them.
int LatencyHistogram::bucketOf(std::uint64_t nanoseconds) noexcept {
    const int octave = std::bit_width(nanoseconds) - 1;
    if (octave < kStepBits) {
        return static_cast<int>(nanoseconds);
    }
    const int shift = octave - kStepBits;
    const int step = static_cast<int>(nanoseconds >> shift) - (1 << kStepBits);
    return std::min(((shift + 1) << kStepBits) + step, kBuckets - 1);
}

double LatencyHistogram::upperEdge(int bucket) noexcept {
    const int row = bucket >> kStepBits;
    const int step = bucket & ((1 << kStepBits) - 1);
    if (row == 0) {
        return step * 1e-9;
    }
    const auto first = static_cast<std::uint64_t>((1 << kStepBits) + step + 1) << (row - 1);
    return static_cast<double>(first - 1) * 1e-9;
}

void LatencyHistogram::add(double seconds) noexcept {
    const double time = std::max(seconds, 0.0);
    constexpr double kMaxTime = 17.0;
    const double nanoseconds = std::min(time, kMaxTime) * 1e9;
    ++counts_[static_cast<std::size_t>(bucketOf(static_cast<std::uint64_t>(nanoseconds)))];
    ++count_;
    largest_ = std::max(largest_, time);
}

void LatencyHistogram::add(const LatencyHistogram& other) noexcept {
    for (std::size_t bucket = 0; bucket < counts_.size(); ++bucket) {
        counts_[bucket] += other.counts_[bucket];
    }
    count_ += other.count_;
    largest_ = std::max(largest_, other.largest_);
}

double LatencyHistogram::quantile(double share) const noexcept {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t seen = 0;
    for (int bucket = 0; bucket < kBuckets; ++bucket) {
        seen += counts_[static_cast<std::size_t>(bucket)];
        if (seen >= wanted && seen > 0) {
            return std::min(upperEdge(bucket), largest_);
        }
    }
    return largest_;
}

LatencyQuantiles LatencyHistogram::quantiles() const noexcept {
    return {.median = quantile(0.5), .p99 = quantile(0.99), .largest = largest_};
}

}  // namespace asperity
