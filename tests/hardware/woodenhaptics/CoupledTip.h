#pragma once

#include "core/haptics/HapticLoop.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/Scene.h"

namespace asperity::test {

/// The handle over the middle of the sample [m], lab frame; 1 mm of the device is 1 nm.
[[nodiscard]] Vector3 handleAt(double height);
inline constexpr double kHigh = 8e-3;      ///< above all that the tip feels [m]
inline constexpr double kPressed = -1e-3;  ///< the tip pushes back with 0.2 N [m]

/// A tip over flat polystyrene, coupled to a device; its forces come on in ten ticks.
class CoupledTip {
public:
    explicit CoupledTip(HapticDevice& device);

    /// The loop's latest tick.
    [[nodiscard]] const TickSample& now() { return loop.snapshot().sample; }
    /// Returns whether the operator feels the tip.
    [[nodiscard]] bool engaged() {
        const Snapshot& latest = loop.snapshot();
        return latest.statistics.ticks > 0 && latest.sample.output.forceState == ForceState::On;
    }

    /// As an operator does who sees a fault. On a busy machine a device seems silent now and then;
    /// the force comes on again, pressed or not.
    void resetFault();

private:
    Scene scene_;
    SimulatedAfm afm_;
    Settings settings_;

public:
    HapticLoop loop;
};

}  // namespace asperity::test
