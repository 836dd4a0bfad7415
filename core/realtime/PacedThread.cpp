#include "core/realtime/PacedThread.h"

#include "core/Error.h"

#include <algorithm>
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

}  // namespace asperity
