#pragma once

#include "hardware/hid/HidTransport.h"

#include <condition_variable>
#include <deque>
#include <mutex>

namespace asperity::test {

using Report = std::vector<std::uint8_t>;

/// HID devices in memory. Any thread plugs, unplugs and sends; what a device was sent stays
/// readable. Of all devices only the first in the list can say something.
class FakeHid final : public HidTransport {
public:
    explicit FakeHid(std::vector<HidDeviceInfo> devices = {}) : devices_(std::move(devices)) {}

    void plug(const HidDeviceInfo& device);
    void unplug();
    /// All reports at once: no reader sees some of them only.
    void send(const std::vector<Report>& reports);
    /// From now on opening fails with this sentence; empty: it works again.
    void refuseToOpen(const std::string& why);
    /// Whether writing fails from now on.
    void refuseToWrite(bool refuse);
    /// From now on a write takes this time.
    void holdWrites(std::chrono::milliseconds time);

    [[nodiscard]] std::vector<Report> written() const;
    [[nodiscard]] int opened() const;  ///< connections that are open now

    std::vector<HidDeviceInfo> enumerate() override;
    std::unique_ptr<HidConnection> open(const std::string& path) override;

private:
    class Connection;

    [[nodiscard]] std::chrono::milliseconds timeOfAWrite() const;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<HidDeviceInfo> devices_;
    std::deque<Report> reports_;
    std::vector<Report> written_;
    std::string refusal_;
    bool refusesWrites_ = false;
    std::chrono::milliseconds writing_{0};  ///< how long a write takes
    int plugging_ = 0;  ///< counts unplugs: a connection from before one is lost
    int opened_ = 0;
};

/// A SpaceMouse as the system lists it.
[[nodiscard]] HidDeviceInfo spaceMouseInfo();

/// A report of the newer devices with a translation in the device's frame [count].
[[nodiscard]] Report motionReport(int x, int y, int z);

}  // namespace asperity::test
