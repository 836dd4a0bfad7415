#pragma once

#include "hardware/woodenhaptics/WoodenHapticsModel.h"

namespace asperity::test {

/// The device whose file ships with the program.
[[nodiscard]] const WoodenHapticsDescription& shippedDevice();

/// Returns the encoders' counts when the handle is here, to the nearest count: the kinematics
/// backwards, by the law of cosines. @param position lab frame, from the workspace's origin [m]
[[nodiscard]] EncoderCounts countsAt(const Vector3& position);

}  // namespace asperity::test
