#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"

#include <cstdint>
#include <limits>

namespace asperity {

/// Geometry that a fixture guides to.
enum class FixtureKind : std::uint8_t {
    None,   ///< nothing: no force
    Plane,  ///< through `point`, across `axis`: free motion in the plane
    Line,   ///< through `point`, along `axis`: free motion along it
    Point,  ///< `point` itself
};

template <>
inline constexpr auto
    kEnumTable<FixtureKind> = std::to_array<EnumRow<FixtureKind>>({{FixtureKind::None, "none"},
                                                                   {FixtureKind::Plane, "plane"},
                                                                   {FixtureKind::Line, "line"},
                                                                   {FixtureKind::Point, "point"}});

/// A guide that helps a device to hold a target. Forces are those at the device; lengths are those
/// of the world in Settings, and for guide() those of the device, see atDeviceScale().
struct VirtualFixture {
    FixtureKind kind = FixtureKind::None;
    Vector3 point = Vector3::Zero();  ///< of the guide, world axes [m]
    Vector3 axis = Vector3::UnitZ();  ///< normal of a plane, direction of a line; world, unit
    double stiffness = 0.0;           ///< k, to the guide, per way of the device [N/m], >= 0
    double damping = 0.0;             ///< b, of the device to and from the guide [N s/m], >= 0
    double forceLimit = 0.0;          ///< that the force nears smoothly [N], >= 0
    /// Distance c from the guide beyond which it lets go [m], > 0.
    double captureDistance = std::numeric_limits<double>::infinity();

    bool operator==(const VirtualFixture&) const = default;
};

/// The ball in which a device can be moved, and the spring that renders its edge; the device's axes
/// and units.
struct Workspace {
    Vector3 center = Vector3::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]; 0: not known, no spring
    double freeShare = 0.9;            ///< of the radius, up to which there is no spring
    double stiffness = 0.0;            ///< of the spring [N/m]
    double forceLimit = 0.0;           ///< of the spring, which nears it smoothly [N]

    bool operator==(const Workspace&) const = default;
};

/// A spring and a damper between the device and a massless proxy, and the proxy's own damper to the
/// frame; the same along every axis, in the device's frame and units. Source: docs/haptics.md.
struct CouplingGains {
    double stiffness = 0.0;     ///< Kc [N/m]; 0: no coupling, the device is the proxy
    double damping = 0.0;       ///< Bc, of device against proxy [N s/m]
    double proxyDamping = 0.0;  ///< bp, of the proxy against the frame: drag in free air [N s/m]

    [[nodiscard]] bool couples() const noexcept { return stiffness > 0.0; }

    bool operator==(const CouplingGains&) const = default;
};

/// Instead of a button's number: there is none.
inline constexpr int kNoButton = -1;
inline constexpr int kLastButton = 31;

/// Limits within which the force governor keeps a rendered force. Source: docs/haptics.md.
struct GovernorLimits {
    double maxForce = 3.0;          ///< the most that the operator shall feel [N]
    double engageTime = 1.0;        ///< in which the force comes on [s], > 0
    double maxDeviceSpeed = 1.5;    ///< above it the device runs away [m/s]
    int deadManButton = kNoButton;  ///< bit of DeviceState::buttons that must be held

    bool operator==(const GovernorLimits&) const = default;
};

/// Position that the device commands.
enum class PositionControl : std::uint8_t {
    Base,  ///< the cantilever's base; the tip stays behind by the lever's deflection
    Tip,   ///< the tip: the base goes ahead by the deflection that the model expects
};

template <>
inline constexpr auto kEnumTable<PositionControl> = std::to_array<EnumRow<PositionControl>>(
    {{PositionControl::Base, "base"}, {PositionControl::Tip, "tip"}});

/// Knobs that may change from one tick to the next.
struct Settings {
    double positionGain = 1.0;          ///< base displacement per device displacement
    double forceGain = 1.0;             ///< device force per force at the tip
    double correctionBandwidth = 20.0;  ///< of the slow correction from the estimate [Hz]
    PositionControl positionControl = PositionControl::Base;
    CouplingGains coupling;   ///< of the device and what it commands
    GovernorLimits governor;  ///< of the force, where the device renders it
    /// Turn from the device's axes to the world's: along its axis, as long as its angle [rad].
    Vector3 deviceTurn = Vector3::Zero();
    Workspace workspace;           ///< of the device
    bool clutched = false;         ///< the device moves, what it commands stays
    int clutchButton = kNoButton;  ///< that does so while it is held
    int trialButton = kNoButton;   ///< that begins and ends a trial of a study
    VirtualFixture guide;          ///< lengths of the world
    bool forcesOn = true;          ///< false: the operator feels nothing
    std::uint32_t rearms = 0;      ///< how often the operator has reset a fault

    bool operator==(const Settings&) const = default;
};

}  // namespace asperity
