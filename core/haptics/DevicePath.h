#pragma once

#include "core/Vector.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// A place of the device at a time; between two of them the device moves in a straight line.
struct PathPoint {
    double time = 0.0;                   ///< [s]
    Vector3 position = Vector3::Zero();  ///< world [m]
};

/// The movement of a scripted device: times rise strictly, at least one point.
using DevicePath = std::vector<PathPoint>;

/// Position at a time; before the first point and after the last the device rests there.
[[nodiscard]] Vector3 positionAt(const DevicePath& path, double time);

/// How far a scripted device goes; lengths are those of the base.
struct PathPlan {
    double duration = 10.0;               ///< [s]
    double clearance = 6e-9;              ///< above first geometric contact, at start and end [m]
    double indentation = 3e-9;            ///< of the base below first geometric contact [m]
    double slideLength = 24e-9;           ///< [m]
    std::optional<Vector2> place = {};    ///< in the scan [m]; empty: each path's own
    std::optional<double> setpoint = {};  ///< of an approach [N]; empty: the scene's
};

/// Height of the base at which the tip first touches the surface from above (x, y) [m].
[[nodiscard]] double touchHeight(const Scene& scene, double x, double y);

// By themselves, paths begin where the scan holds data, if it does so anywhere in its middle part.

/// Where a path begins, out of the sample's reach: above its place, or by itself above the highest
/// feature of the scan [m].
[[nodiscard]] Vector3 pathStart(const Scene& scene, const PathPlan& plan);

/// Approach, indent, slide and retract; by itself at the highest feature of the scan.
[[nodiscard]] DevicePath slidePath(const Scene& scene, const PathPlan& plan);

/// Lines to and fro over a square, in contact; by itself around the highest feature.
[[nodiscard]] DevicePath rasterPath(const Scene& scene, const PathPlan& plan);

/// One long line along x, ever deeper; by itself across the middle of the scan.
[[nodiscard]] DevicePath scratchPath(const Scene& scene, const PathPlan& plan);

/// Where the base waits above a place of the scan (x, y), out of the sample's reach [m].
[[nodiscard]] Vector3 waitingPlace(const Scene& scene, const Vector2& place);

/// Up over everything on the way, across, and down to the waiting place above (x, y) [m].
[[nodiscard]] DevicePath journey(const Scene& scene, const Vector3& from, const Vector2& to,
                                 double duration);

}  // namespace asperity
