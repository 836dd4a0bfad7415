#pragma once

#include "hardware/woodenhaptics/WoodenHaptics.h"

#include <functional>

namespace asperity::test {

/// Returns whether the device says that it waits for its handle to be put into the rest pose.
bool waitsForCalibration(const WoodenHaptics& device);

/// As an operator does who sees that a device waits for it: then reports to it that it is in its
/// rest pose.
/// @param speak has the device send a reading, where it does not do so by itself
/// @return whether it is connected in the end
bool calibrateWhenItWaits(
    WoodenHaptics& device, const std::function<void()>& speak = [] {});

}  // namespace asperity::test
