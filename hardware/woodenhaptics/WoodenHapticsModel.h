#pragma once

#include "core/haptics/device/WoodenHapticsDescription.h"

#include <array>
#include <cstdint>

namespace asperity {

/// Of the encoders a, b, c.
using EncoderCounts = std::array<std::int16_t, 3>;

// Source of the laws: docs/device_protocols.md 2. Vectors are in the device frame.

/// Angles A, B, C of the joints: a about z, 0 where the arm points to the operator; b and c against
/// the vertical, 0 where body b stands and body c hangs [rad].
[[nodiscard]] Vector3 jointAngles(const WoodenHapticsDescription& device,
                                  const EncoderCounts& counts) noexcept;

/// Where the handle is [m].
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

/// From the device's frame to the lab's: x right, y away from the operator, z up.
[[nodiscard]] Vector3 inLabFrame(const Vector3& inDevice) noexcept;
/// And back.
[[nodiscard]] Vector3 inDeviceFrame(const Vector3& inLab) noexcept;

}  // namespace asperity
