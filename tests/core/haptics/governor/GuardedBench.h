#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/probe/SimulatedAfm.h"
#include "core/scene/Scene.h"

#include <functional>
#include <vector>

namespace asperity::test {

/// An operator at a Phantom class device with motors, coupled to a tip over flat polystyrene, at 1
/// kHz of virtual time: 1 mm of the device is 1 nm, 1 N is 10 nN. What the device says can be
/// tampered with, to inject faults.
class GuardedBench {
public:
    GuardedBench();
    /// The same operator and device at another scene.
    /// @param start of the handle, the device's frame [m]
    GuardedBench(const Scene& scene, const Vector3& start);

    /// Where the operator wants the handle from now on: height over the sample [m].
    void reachFor(double height);
    /// The same anywhere; the device's frame [m].
    void reachFor(const Vector3& position);
    /// @return the ticks of this time [s], whose samples give the time since the beginning
    std::vector<TickSample> run(double duration);
    /// Engages high over the sample, then goes down and presses. @return the force there [N]
    double pressDown();

    TickInput input;    ///< of the last tick; its settings are those of the next one
    TickMemory memory;  ///< what the next tick starts from
    std::function<void(DeviceState&, double time)>
        tamper;  ///< with what the device tells at a time
    [[nodiscard]] double now() const noexcept { return time_; }
    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }

private:
    TickSample step();

    Scene scene_;
    VirtualBench bench_;
    SimulatedAfm afm_;
    double time_ = 0.0;  ///< of the last tick [s]
};

}  // namespace asperity::test
