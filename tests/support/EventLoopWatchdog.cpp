#include "tests/support/EventLoopWatchdog.h"

#include "tests/support/MachineSpeed.h"

#include <QCoreApplication>
#include <QEvent>
#include <QObject>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sys/syscall.h>
#include <unistd.h>

namespace asperity::test {

namespace {

constexpr auto kAskEvery = std::chrono::milliseconds(2);

/// What the kernel says of a thread.
struct ThreadTimes {
    double running = 0.0;  ///< [s]
    double waiting = 0.0;  ///< ready to run, but others had the processors [s]
};

/// Zeros for a thread that has ended.
ThreadTimes timesOf(const std::filesystem::path& task) {
    double running = 0.0;
    double waiting = 0.0;
    std::ifstream(task / "schedstat") >> running >> waiting;
    return {1e-9 * running, 1e-9 * waiting};
}

/// Time that all threads of this process waited for a processor, and that a hypervisor took from
/// the machine [s].
double timeTaken() {
    double taken = 0.0;
    std::error_code gone;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", gone)) {
        taken += timesOf(task.path()).waiting;
    }
    std::string cpu;
    double ticks = 0.0;
    std::ifstream stat("/proc/stat");
    stat >> cpu;
    constexpr int kStolen = 8;  // proc(5): the eighth number
    for (int column = 1; column <= kStolen; ++column) {
        stat >> ticks;
    }
    return taken + ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double now() {
    const auto time = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(time).count();
}

}  // namespace

class EventLoopWatchdog::Answer : public QObject {
public:
    explicit Answer(EventLoopWatchdog& watchdog) : watchdog_(watchdog) {}
    bool event(QEvent* event) override {
        if (event->type() != QEvent::User) {
            return QObject::event(event);
        }
        const std::lock_guard lock(watchdog_.mutex_);
        watchdog_.answered_ = true;
        watchdog_.changed_.notify_all();
        return true;
    }

private:
    EventLoopWatchdog& watchdog_;
};

EventLoopWatchdog::EventLoopWatchdog()
    : slowness_(machineSlowness())
    , answers_(std::make_unique<Answer>(*this))
    , watchedThread_(static_cast<int>(syscall(SYS_gettid)))
    , thread_([this] { watch(); }) {}

EventLoopWatchdog::~EventLoopWatchdog() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        changed_.notify_all();
    }
    thread_.join();
}

bool EventLoopWatchdog::waitForAnswer() {
    std::unique_lock lock(mutex_);
    answered_ = false;
    QCoreApplication::postEvent(answers_.get(), new QEvent(QEvent::User), Qt::HighEventPriority);
    changed_.wait(lock, [this] { return answered_ || ending_; });
    return !ending_;
}

void EventLoopWatchdog::watch() {
    const std::filesystem::path watched = "/proc/self/task/" + std::to_string(watchedThread_);
    double start = now();
    double takenBefore = timeTaken();
    double runningBefore = timesOf(watched).running;
    while (waitForAnswer()) {
        const double wall = now() - start;
        const double taken = std::max(0.0, timeTaken() - takenBefore);
        keep({.step = {},
              .wall = wall,
              .own = std::max(0.0, wall - taken),
              .processor = std::min(wall, timesOf(watched).running - runningBefore)});
        std::this_thread::sleep_for(kAskEvery);
        start = now();
        takenBefore = timeTaken();
        runningBefore = timesOf(watched).running;
    }
}

void EventLoopWatchdog::keep(const BlockedStretch& stretch) {
    const std::lock_guard lock(mutex_);
    auto row = std::ranges::find(longest_, step_, &BlockedStretch::step);
    if (row == longest_.end()) {
        longest_.push_back({.step = step_});
        row = longest_.end() - 1;
    }
    if (std::max(stretch.own, stretch.processor) > std::max(row->own, row->processor)) {
        *row = stretch;
        row->step = step_;
    }
}

void EventLoopWatchdog::enter(const std::string& step) {
    const std::lock_guard lock(mutex_);
    step_ = step;
}

std::vector<BlockedStretch> EventLoopWatchdog::longest() const {
    const std::lock_guard lock(mutex_);
    return longest_;
}

double EventLoopWatchdog::longestBlock() const {
    return kLongestBlock * std::max(slowness_, machineSlowness());
}

std::string tableOf(const std::vector<BlockedStretch>& stretches) {
    std::string table = "longest time without an answer [ms]\n  wall   own  cpu  step\n";
    for (const BlockedStretch& stretch : stretches) {
        char line[160];
        std::snprintf(line, sizeof line, "%6.0f %5.0f %4.0f  %s\n", 1e3 * stretch.wall,
                      1e3 * stretch.own, 1e3 * stretch.processor, stretch.step.c_str());
        table += line;
    }
    return table;
}

}  // namespace asperity::test
