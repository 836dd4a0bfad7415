#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"

#include <cstdint>
#include <limits>

namespace asperity {

/// What a fixture guides to.
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

}  // namespace asperity
