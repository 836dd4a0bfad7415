#pragma once

#include "core/io/scene/DeviceFiles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asperity {

/// Counts of the encoders a, b, c.
using EncoderCounts = std::array<std::int16_t, 3>;

// Source of the laws: docs/device_protocols.md 2. Vectors are in the device frame.

/// Angles A, B, C of the joints: a about z, 0 where the arm points to the operator; b and c against
/// the vertical, 0 where body b is upright and body c hangs [rad].
[[nodiscard]] Vector3 jointAngles(const WoodenHapticsDescription& device,
                                  const EncoderCounts& counts) noexcept;

/// Returns the position of the handle [m].
[[nodiscard]] Vector3 handlePosition(const WoodenHapticsDescription& device,
                                     const Vector3& angles) noexcept;

/// Torques of the joints with which the handle pushes the device by `force` [N]: the transposed
/// Jacobian of the position times the force [N m].
[[nodiscard]] Vector3 jointTorques(const WoodenHapticsDescription& device, const Vector3& angles,
                                   const Vector3& force) noexcept;

/// Currents of the motors that give these torques [A]. Where one would pass the amplifiers' limit
/// all are lowered alike: the force at the handle keeps its direction. None for torques that are
/// not finite.
[[nodiscard]] Vector3 motorCurrents(const WoodenHapticsDescription& device,
                                    const Vector3& torques) noexcept;

/// Transforms from the device's frame to the lab's: x right, y away from the operator, z up.
[[nodiscard]] Vector3 inLabFrame(const Vector3& inDevice) noexcept;
/// And back.
[[nodiscard]] Vector3 inDeviceFrame(const Vector3& inLab) noexcept;

/// The two boards that drive a WoodenHaptics; they say the same in reports of different length.
enum class WoodenHapticsBoard : std::uint8_t { Teensy, Mbed };

/// The board with these ids, or nothing.
[[nodiscard]] std::optional<WoodenHapticsBoard> woodenHapticsBoard(std::uint16_t vendorId,
                                                                   std::uint16_t productId);

/// Content of one report of the device.
struct WoodenHapticsReading {
    EncoderCounts counts{};
    bool button = false;  ///< of Polhem's handle
};

/// Nothing when the report has not the length of this board's. Source: docs/device_protocols.md 2:
/// little-endian, no report id; Polhem adds 10000 to the encoder d while its button is down.
[[nodiscard]] std::optional<WoodenHapticsReading>
readingOf(WoodenHapticsBoard board, std::span<const std::uint8_t> report) noexcept;

/// An output report for HidConnection::write(): a zero in place of a report id comes first.
struct WoodenHapticsMessage {
    std::array<std::uint8_t, 65> bytes{};
    std::size_t size = 0;  ///< of them that this board reads

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
