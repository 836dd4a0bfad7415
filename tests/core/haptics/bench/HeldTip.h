#pragma once

#include "core/haptics/HapticTick.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/surface/HeightMap.h"

#include <functional>
#include <string>

namespace asperity::test {

/// A map of a material of data/materials under the 14 N/m lever; 1 mm of the device is 1 nm, 1 N is
/// 10 nN over `magnified`.
[[nodiscard]] Scene hapticScene(const std::string& material, const HeightMap& map,
                                double tickRate = 1000.0, double magnified = 1.0);

/// The coupling designed for a Phantom class device that is late by `delay` [s].
[[nodiscard]] CouplingGains designed(const Scene& scene, double delay);

/// One operator at one device.
struct Hold {
    BenchSetup bench;
    CouplingGains coupling;  ///< without stiffness: the device moves the base itself
    VirtualFixture guide;    ///< lengths of the world
    double goal = -3e-3;     ///< height that the operator reaches for, device frame [m]
    double lift = 0.0;       ///< by which the goal is raised after half a second [m]
    bool letGo = false;      ///< whether the operator lets go after half a second
};

/// How a tip is held when the device has gone down to its goal, within 10 ms and from a height of 4
/// mm, and has had two seconds to settle.
struct HeldTip {
    double peakToPeak = 0.0;             ///< of the handle along z, over half a second [m]
    Vector3 force = Vector3::Zero();     ///< on the device, its mean over that time [N]
    Vector3 handle = Vector3::Zero();    ///< where it is in the end [m]
    Vector3 tipForce = Vector3::Zero();  ///< of the sample on the true tip, its mean [N]
};

/// Where the handle is as sensed [m] and the force sent to it [N], tick by tick.
using PortWatch = std::function<void(const Vector3& device, const Vector3& force)>;

[[nodiscard]] HeldTip holdTip(const Scene& scene, const Hold& hold, const PortWatch& watch = {});

}  // namespace asperity::test
