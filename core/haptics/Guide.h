#pragma once

#include "core/haptics/fixtures/VirtualFixture.h"
#include "core/scene/TickInput.h"

namespace asperity {

/// What one tick hands to the next about the guide.
struct GuideMemory {
    VirtualFixture fixture;              ///< as the last tick's settings had it
    double positionGain = 0.0;           ///< likewise
    double share = 0.0;                  ///< of its force limit that acts, 0 to 1
    Vector3 velocity = Vector3::Zero();  ///< of the proxy, world axes, at the device [m/s]
};

/// What the guide does in one tick; world axes, at the device.
struct GuideStep {
    Vector3 force = Vector3::Zero();  ///< on the proxy [N]
    double share = 0.0;               ///< of its force limit that acts
    bool changed = false;             ///< it is another guide, or lies elsewhere for the device
};

/// The guide of the settings as a load of the proxy. Its force limit comes on linearly in half a
/// second: one that is switched on, moved or zoomed away from the device holds energy that nobody
/// put in, and must not give it at once.
/// @param place     that the device commanded in the last tick, world [m]
[[nodiscard]] GuideStep stepGuide(const TickInput& input, const Vector3& place,
                                  const GuideMemory& memory) noexcept;

/// What the next tick starts from.
/// @param motion of the proxy in this tick, world axes, at the device [m]
[[nodiscard]] GuideMemory guideAfter(const TickInput& input, const GuideStep& step,
                                     const Vector3& motion) noexcept;

}  // namespace asperity
