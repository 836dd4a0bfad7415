#include "hardware/hid/HidFollower.h"

#include <csignal>
#include <exception>
#include <utility>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kSearchPeriod{500};  // between two looks for the device

/// A signal would interrupt the wait for a report and look like a lost device.
void leaveSignalsToOtherThreads() {
    sigset_t all{};
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

HidFollower::HidFollower(HidTransport& transport, HidKind isOfKind, const char* label)
    : transport_(transport), isOfKind_(isOfKind), label_(label), found_(find()) {}

void HidFollower::start(Follow follow) {
    thread_ = std::jthread(
        [this, follow = std::move(follow)](const std::stop_token& stop) { run(follow, stop); });
}

DeviceStatus HidFollower::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void HidFollower::setStatus(DeviceStatus status) {
    const std::lock_guard lock(mutex_);
    status_ = std::move(status);
}

/// The first device of the kind that can be opened, or none.
FoundDevice HidFollower::find() {
    DeviceStatus none{.problem = DeviceProblem::NotPluggedIn, .driver = label_};
    try {
        for (const HidDeviceInfo& device : transport_.enumerate()) {
            if (isOfKind_(device) && device.permitted) {
                FoundDevice found = {device, transport_.open(device.path)};
                setStatus({.driver = label_, .name = device.name(), .path = device.path});
                return found;
            }
            if (isOfKind_(device)) {
                none.problem = DeviceProblem::NotPermitted;
                none.path = device.path;
            }
        }
    } catch (const std::exception& error) {
        none.problem = DeviceProblem::NotOpened;
        none.reason = error.what();
    }
    setStatus(none);
    return {};
}

void HidFollower::run(const Follow& follow, const std::stop_token& stop) {
    leaveSignalsToOtherThreads();
    while (!stop.stop_requested()) {
        if (found_.connection) {
            follow(found_, stop);
            found_.connection.reset();
            setStatus({.problem = DeviceProblem::Unplugged, .driver = label_});
        }
        if (pauseUnlessStopped(stop)) {
            found_ = find();
        }
    }
}

/// @return false when a stop was asked for
bool HidFollower::pauseUnlessStopped(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    wakeUp_.wait_for(lock, stop, kSearchPeriod, [] { return false; });
    return !stop.stop_requested();
}

}  // namespace asperity
