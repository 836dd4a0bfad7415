#pragma once

#include "core/haptics/HapticTick.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <cstdint>

namespace asperity::test {

inline constexpr CouplingGains kGains{.stiffness = 400.0, .damping = 3.0, .proxyDamping = 3.0};

/// Silicon oxide without noise under a device for which 1 mm is 1 nm and 1 N is 10 nN.
[[nodiscard]] Scene coupledScene(const CouplingGains& gains, const HeightMap& map);
/// The same on a flat sample.
[[nodiscard]] Scene coupledScene(const CouplingGains& gains);

/// A device that goes where the test moves it, with tick and instrument.
class GuidedDevice {
public:
    explicit GuidedDevice(const Scene& scene)
        : settings(scene.settings), scene_(scene), afm_(scene.trueSurface(), truthOf(scene)) {}

    TickOutput moveTo(const Vector3& target, int ticks = 1);
    /// At a speed that a hand has, in half of the ticks; then it stays.
    TickOutput glideTo(const Vector3& target, int ticks);

    Settings settings;
    DeviceState device;  ///< what it is; the position is that of moveTo()
    std::uint32_t starts = 0;

private:
    const Scene& scene_;
    Vector3 position_ = Vector3::Zero();  ///< [m]
    SimulatedAfm afm_;
    TickMemory memory_;
};

}  // namespace asperity::test
