#pragma once

#include "core/Vector.h"
#include "core/probe/AfmController.h"
#include "core/scene/Settings.h"

#include <cstdint>

namespace asperity {

/// What the device knows of the hand; the hand's frame is the lab's frame scaled.
struct HandState {
    Vector3 position = Vector3::Zero();  ///< [m]
    std::uint32_t buttons = 0;           ///< bit i: button i is down
    bool connected = true;               ///< false: the device is lost, the position its last
};

/// All that one tick depends on besides the scene and its memory: what a recording holds.
struct TickInput {
    HandState hand;
    AfmMeasurement measurement;
    Settings settings;
    double timeStep = 1e-3;  ///< [s]
};

}  // namespace asperity
