#pragma once

#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asperity {

/// The two boards that drive a WoodenHaptics; they say the same in reports of different length.
enum class WoodenHapticsBoard : std::uint8_t { Teensy, Mbed };

/// The board with these ids, or nothing.
[[nodiscard]] std::optional<WoodenHapticsBoard> woodenHapticsBoard(std::uint16_t vendorId,
                                                                   std::uint16_t productId);

/// What one report of the device says.
struct WoodenHapticsReading {
    EncoderCounts counts{};
    bool button = false;  ///< of Polhem's handle
};

/// Nothing when the report has not the length of this board's. Source: docs/device_protocols.md 2:
/// little-endian, no report id; Polhem adds 10000 to the encoder d while its button is down.
[[nodiscard]] std::optional<WoodenHapticsReading>
readingOf(WoodenHapticsBoard board, std::span<const std::uint8_t> report) noexcept;

/// An output report as HidConnection::write() takes it: a zero in place of a report id comes first.
struct WoodenHapticsMessage {
    std::array<std::uint8_t, 65> bytes{};
    std::size_t size = 0;  ///< of them that this board takes

    [[nodiscard]] std::span<const std::uint8_t> report() const noexcept {
        return std::span(bytes).first(size);
    }
};

/// Sets the currents of the motors a, b, c, finite [A]; to the milliampere.
[[nodiscard]] WoodenHapticsMessage currentsMessage(WoodenHapticsBoard board,
                                                   const Vector3& currents) noexcept;

/// Sets the encoders a, b, c; d to f and the currents become 0.
[[nodiscard]] WoodenHapticsMessage encodersMessage(WoodenHapticsBoard board,
                                                   const EncoderCounts& counts) noexcept;

}  // namespace asperity
