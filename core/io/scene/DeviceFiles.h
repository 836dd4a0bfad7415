#pragma once

#include "core/Vector.h"
#include "core/haptics/device/HapticDevice.h"

#include <array>
#include <cstdint>
#include <filesystem>

namespace asperity {

/// One joint of a WoodenHaptics: a motor with an encoder turns a body over a capstan.
struct WoodenHapticsJoint {
    double length = 0.0;           ///< of the body [m]
    double capstanDiameter = 0.0;  ///< on the motor's shaft [m]
    double bodyDiameter = 0.0;     ///< of the body where the capstan's cable runs [m]
    double sign = 1.0;             ///< -1: the joint's angle falls as the counts rise; else 1
    std::int16_t restCounts = 0;   ///< of the encoder in the rest pose

    /// Turn of the joint per turn of the motor, with its sign.
    [[nodiscard]] double reduction() const noexcept {
        return sign * capstanDiameter / bodyDiameter;
    }
};

/// One make of WoodenHaptics. Device frame: x to the operator, y right, z up.
/// Source: docs/device_protocols.md 2.
struct WoodenHapticsDescription {
    std::array<WoodenHapticsJoint, 3> joints;  ///< a turns about z; b and c lift, both against z
    Vector3 origin = Vector3::Zero();  ///< of positions, from the base of joint a; device frame [m]
    double countsPerTurn = 0.0;        ///< of a motor's encoder
    double motorConstant = 0.0;        ///< torque per current [N m/A]
    double maxCurrent = 0.0;           ///< that the amplifiers give for as long as they must [A]
    DeviceSpecification specification;
};

/// A device file (TOML) of a WoodenHaptics; every key is documented in docs/devices.md. Only what
/// its maker may not know can be left out: wrong geometry would push in the wrong direction. @throw
/// InputError
[[nodiscard]] WoodenHapticsDescription readWoodenHaptics(const std::filesystem::path& path);

}  // namespace asperity
