#pragma once

#include "core/haptics/HandPath.h"
#include "core/haptics/HapticDevice.h"

namespace asperity {

/// A hand that follows a path, then rests at its end.
class ScriptedHand final : public HapticDevice {
public:
    /// @param path         of the base, world
    /// @param positionGain base displacement per hand displacement while the path runs
    ScriptedHand(HandPath path, double positionGain);

    HandState advance(double timeStep) noexcept override;

private:
    HandPath path_;
    double positionGain_;
    double time_ = 0.0;     ///< along the path [s]
    bool started_ = false;  ///< the first step only begins
};

}  // namespace asperity
