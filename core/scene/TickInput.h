#pragma once

#include "core/Vector.h"
#include "core/probe/AfmController.h"
#include "core/scene/Settings.h"

#include <cstdint>

namespace asperity {

/// State of the device as the loop knows it; its frame is the lab's frame scaled.
struct DeviceState {
    Vector3 position = Vector3::Zero();  ///< [m]
    std::uint32_t buttons = 0;           ///< bit i: button i is down
    bool connected = true;               ///< false: the device is lost, the position its last
    double maxForce = 0.0;               ///< that its motors render [N]; 0: it only senses
    bool streams = false;  ///< it reports all the time: that it falls silent is a fault
    double age = 0.0;      ///< of its newest report [s]

    /// Returns whether the force governor is between tick and device.
    [[nodiscard]] bool rendersForce() const noexcept { return maxForce > 0.0; }
    /// Returns whether a button is down; kNoButton never is.
    [[nodiscard]] bool holds(int button) const noexcept {
        return button != kNoButton && ((buttons >> static_cast<unsigned>(button)) & 1U) != 0U;
    }
};

/// All that one tick depends on besides the scene and its memory: what a recording holds.
struct TickInput {
    DeviceState device;
    AfmMeasurement measurement;
    Settings settings;
    double timeStep = 1e-3;    ///< [s]
    std::uint32_t starts = 0;  ///< of the loop: after each the force comes on again

    /// Returns whether the device moves without commanding anything.
    [[nodiscard]] bool clutched() const noexcept {
        return settings.clutched || device.holds(settings.clutchButton);
    }
};

}  // namespace asperity
