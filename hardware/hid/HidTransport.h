#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Usage of a collection of a HID device, in the numbers of the HID Usage Tables.
struct HidUsage {
    std::uint16_t page = 0;
    std::uint16_t id = 0;
    bool operator==(const HidUsage&) const = default;
};

/// One HID device as the system lists it, without opening it. Text is UTF-8.
struct HidDeviceInfo {
    std::string path;  ///< names the device for open()
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::string manufacturer;
    std::string product;
    std::string serial;
    std::vector<HidUsage> usages;  ///< of all its collections
    bool permitted = true;         ///< this user may read and write it

    /// Returns whether one of its collections is for this.
    [[nodiscard]] bool hasCollection(const HidUsage& usage) const {
        return std::ranges::find(usages, usage) != usages.end();
    }
    /// Returns its name for a user.
    [[nodiscard]] std::string name() const {
        if (!product.empty()) {
            return product;
        }
        return manufacturer.empty() ? "HID device" : manufacturer + " HID device";
    }
};

/// An open HID device. One thread owns it: it alone may call what is here.
class HidConnection {
public:
    virtual ~HidConnection() = default;

    /// The oldest report that waits, its id first. Waits up to `patience` for one.
    /// @return bytes written to `report`, 0: none came in time, nothing: the device is lost
    virtual std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                            std::chrono::milliseconds patience) = 0;

    /// Sends an output report, its id first. May take milliseconds, at worst seconds.
    /// @return whether the device accepted it
    virtual bool write(std::span<const std::uint8_t> report) = 0;
};

/// The access to HID devices: the system's, or one made up by a test. Any thread.
class HidTransport {
public:
    virtual ~HidTransport() = default;

    /// Every HID device, each once. @throw Error when the system cannot list them
    virtual std::vector<HidDeviceInfo> enumerate() = 0;

    /// @throw Error with the reason and the remedy
    virtual std::unique_ptr<HidConnection> open(const std::string& path) = 0;
};

}  // namespace asperity
