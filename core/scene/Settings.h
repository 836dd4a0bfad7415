#pragma once

#include <cstdint>

namespace asperity {

/// Knobs that may change from one tick to the next.
struct Settings {
    double positionGain = 1.0;          ///< base displacement per hand displacement
    double forceGain = 1.0;             ///< force at the hand per force at the tip
    double correctionBandwidth = 20.0;  ///< of the slow correction from the estimate [Hz]
    bool forcesOn = true;               ///< false: the hand feels nothing
    std::uint32_t rearms = 0;           ///< how often a person has taken back a fault
};

}  // namespace asperity
