#include "hardware/hid/HidFollower.h"

#include <csignal>
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

HidFollower::HidFollower(HidTransport& transport, const DeviceDriver& driver)
    : transport_(transport), driver_(driver), found_(find()) {}

void HidFollower::start(Follow follow) {
    thread_ = std::jthread(
        [this, follow = std::move(follow)](const std::stop_token& stop) { run(follow, stop); });
}

std::string HidFollower::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void HidFollower::setStatus(std::string status) {
    const std::lock_guard lock(mutex_);
    status_ = std::move(status);
}

/// The first device of the driver that can be opened, or none.
FoundDevice HidFollower::find() {
    std::string problem = std::string("no ") + driver_.name + " is plugged in";
    try {
        for (const HidDeviceInfo& device : transport_.enumerate()) {
            if (driver_.drives(device) && device.permitted) {
                FoundDevice found = {device, transport_.open(device.path)};
                setStatus(device.name() + " at " + device.path);
                return found;
            }
            if (driver_.drives(device)) {
                problem = device.path + ": " + kNoPermission;
            }
        }
    } catch (const std::exception& error) {
        problem = error.what();
    }
    setStatus(problem);
    return {};
}

void HidFollower::run(const Follow& follow, const std::stop_token& stop) {
    leaveSignalsToOtherThreads();
    while (!stop.stop_requested()) {
        if (found_.connection) {
            follow(found_, stop);
            found_.connection.reset();
            setStatus(std::string("the ") + driver_.name + " was unplugged");
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
