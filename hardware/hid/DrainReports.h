#pragma once

#include "hardware/hid/HidTransport.h"

#include <array>

namespace asperity {

/// What a device had to say.
enum class Drained : std::uint8_t {
    All,       ///< all reports that waited, or none came in time
    Overflow,  ///< the kernel's queue was full: the newest reports are gone
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
