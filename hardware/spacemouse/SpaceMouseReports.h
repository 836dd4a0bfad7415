#pragma once

#include "core/Vector.h"

#include <cstdint>
#include <span>

namespace asperity {

/// How the knob of a SpaceMouse is pushed and which of its buttons are down. Lab frame: x right, y
/// away from the operator (up in the image), z up; rotations right-handed about these axes.
struct SpaceMouseState {
    Vector3 translation = Vector3::Zero();  ///< -1..1 an axis
    Vector3 rotation = Vector3::Zero();     ///< -1..1 an axis
    std::uint32_t buttons = 0;              ///< bit i: button i is down
};

/// What the device says once it has also sent `report` (its id first): translation and rotation in
/// one report or, older, in two; buttons in another. A report that is not known, or that has not
/// the length it must have, changes nothing. Source: docs/device_protocols.md 1: little-endian,
/// +-350, x right, y to the operator, z down.
[[nodiscard]] SpaceMouseState afterReport(const SpaceMouseState& before,
                                          std::span<const std::uint8_t> report) noexcept;

}  // namespace asperity
