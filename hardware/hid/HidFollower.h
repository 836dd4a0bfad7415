#pragma once

#include "core/haptics/device/DeviceStatus.h"
#include "hardware/hid/HidList.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace asperity {

/// A device that was found, and the connection to it.
struct FoundDevice {
    HidDeviceInfo info;
    std::unique_ptr<HidConnection> connection;
};

/// Follows the first device of one kind that can be opened, on a thread of its own, and without
/// one looks for it twice a second.
class HidFollower {
public:
    /// Runs on the follower's thread, until the device is lost or a stop is asked for.
    using Follow = std::function<void(const FoundDevice&, const std::stop_token&)>;

    /// Looks once. @param transport must outlive the follower
    /// @param label of the kind, for people
    HidFollower(HidTransport& transport, HidKind isOfKind, const char* label);

    /// Whether it has a device; only before start().
    [[nodiscard]] bool hasDevice() const noexcept { return found_.connection != nullptr; }

    /// Once. The follower's end stops the thread and waits for it: what `follow` uses must outlive
    /// the follower.
    void start(Follow follow);

    /// Which device it is, or why there is none. Any thread.
    [[nodiscard]] DeviceStatus status() const;

private:
    [[nodiscard]] FoundDevice find();
    void run(const Follow& follow, const std::stop_token& stop);
    bool pauseUnlessStopped(const std::stop_token& stop);
    void setStatus(DeviceStatus status);

    HidTransport& transport_;
    HidKind isOfKind_;
    const char* label_;

    mutable std::mutex mutex_;  ///< guards the status
    DeviceStatus status_;
    std::condition_variable_any wakeUp_;

    FoundDevice found_;    ///< the thread's own once that runs
    std::jthread thread_;  ///< last: it uses all the others
};

}  // namespace asperity
