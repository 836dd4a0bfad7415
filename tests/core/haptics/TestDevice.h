#pragma once

#include "core/haptics/device/HapticDevice.h"

namespace asperity::test {

/// A Phantom class device, as designCoupling() needs it.
inline constexpr DeviceSpecification kPhantom{
    .maxForce = 8.5, .maxStiffness = 800.0, .maxDamping = 8.0, .effectiveMass = 0.075};

inline constexpr double kTick = 1e-3;  ///< of a loop at 1 kHz [s]

}  // namespace asperity::test
