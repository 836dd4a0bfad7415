#pragma once

#include "core/haptics/device/HapticDevice.h"
#include "hardware/hid/HidTransport.h"
#include "hardware/hid/HidapiTransport.h"

#include <array>
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

    /// Returns whether it has a device; only before start().
    [[nodiscard]] bool hasDevice() const noexcept { return found_.connection != nullptr; }

    /// Once. The follower's end stops the thread and waits for it: what `follow` uses must outlive
    /// the follower.
    void start(Follow follow);

    /// Returns which device it is, or why there is none. Any thread.
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

/// Result of reading a device's waiting reports.
enum class Drained : std::uint8_t {
    All,       ///< all reports that waited, or none came in time
    Overflow,  ///< the kernel's queue was full: the newest reports are lost
    Lost,      ///< the device is lost
};

/// Hands each report that waits to `take`, the oldest first. Waits up to `patience` for the
/// first.
template <typename Take>
Drained drainReports(HidConnection& device, std::chrono::milliseconds patience, const Take& take) {
    constexpr std::size_t kMaxReportSize = 64;  // of a full-speed USB device [byte]
    constexpr int kKernelQueue = 63;  // reports that the kernel keeps; it drops later ones
    std::array<std::uint8_t, kMaxReportSize> report{};
    for (int count = 0; count < kKernelQueue; ++count) {
        const std::optional<std::size_t> size = device.read(report, patience);
        if (!size) {
            return Drained::Lost;
        }
        if (*size == 0) {
            return Drained::All;
        }
        take(std::span<const std::uint8_t>(report).first(*size));
        patience = std::chrono::milliseconds(0);
    }
    return Drained::Overflow;
}

}  // namespace asperity
