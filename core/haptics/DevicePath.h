#pragma once

#include "core/Vector.h"
#include "core/haptics/device/HapticDevice.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

struct Scene;

/// A position of the device at a time; between two of them the device moves in a straight line.
struct PathPoint {
    double time = 0.0;                   ///< [s]
    Vector3 position = Vector3::Zero();  ///< world [m]
};

/// The movement of a scripted device: times rise strictly, at least one point.
using DevicePath = std::vector<PathPoint>;

/// Position at a time; before the first point and after the last the device rests there.
[[nodiscard]] Vector3 positionAt(const DevicePath& path, double time);

/// Size and duration of a scripted device's path; lengths are those of the base.
struct PathPlan {
    double duration = 10.0;                ///< [s]
    double clearance = 6e-9;               ///< above first geometric contact, at start and end [m]
    double indentation = 3e-9;             ///< of the base below first geometric contact [m]
    double slideLength = 24e-9;            ///< [m]
    std::optional<Vector2> position = {};  ///< in the scan [m]; empty: each path's own
    std::optional<double> setpoint = {};   ///< of an approach [N]; empty: the scene's
};

/// Height of the base at which the tip first touches the surface from above (x, y) [m].
[[nodiscard]] double touchHeight(const Scene& scene, double x, double y);

// By themselves, paths begin where the scan holds data, if it does so anywhere in its middle part.

/// Returns the start of a path, out of the sample's reach: above its position or, if it has none,
/// above the highest feature of the scan [m].
[[nodiscard]] Vector3 pathStart(const Scene& scene, const PathPlan& plan);

/// Approach, indent, slide and retract; by itself at the highest feature of the scan.
[[nodiscard]] DevicePath slidePath(const Scene& scene, const PathPlan& plan);

/// Lines to and fro over a square, in contact; by itself around the highest feature.
[[nodiscard]] DevicePath rasterPath(const Scene& scene, const PathPlan& plan);

/// One long line along x, ever deeper; by itself across the middle of the scan.
[[nodiscard]] DevicePath scratchPath(const Scene& scene, const PathPlan& plan);

/// Lines to and fro along the sample.
struct LinesPlan {
    double length = 100e-9;  ///< of a line [m]
    double speed = 100e-9;   ///< along it, and to the next one [m/s]
    double direction = 0.0;  ///< of the first way, from world x to y [rad]
    int lines = 1;           ///< to and fro each
    double pitch = 0.0;      ///< from a line to the next, left of the direction; 0: the same [m]
};

/// Returns the lines from where the base is, at its height.
[[nodiscard]] DevicePath linesPath(const Vector3& from, const LinesPlan& plan);

/// Returns where the base waits above a position of the scan (x, y), out of the sample's reach [m].
[[nodiscard]] Vector3 waitingPosition(const Scene& scene, const Vector2& position);

/// Up over everything on the way, across, and down to the waiting position above (x, y) [m].
[[nodiscard]] DevicePath journey(const Scene& scene, const Vector3& from, const Vector2& to,
                                 double duration);

/// A device that follows a path, then rests at its end.
class ScriptedDevice final : public HapticDevice {
public:
    /// Makes a device for a run that begins with it.
    /// @param path         of the base, world [m]
    /// @param positionGain base displacement per device displacement while the path runs
    ScriptedDevice(DevicePath path, double positionGain);
    /// Makes a device that takes over from another one.
    /// @param start where that one is, in the device's frame, while the base is where `path` begins
    ScriptedDevice(DevicePath path, double positionGain, Vector3 start);

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double timeStep) noexcept override;

private:
    DevicePath path_;
    double positionGain_;
    Vector3 start_;         ///< of the device [m]
    double time_ = 0.0;     ///< along the path [s]
    bool started_ = false;  ///< the first step only begins
};

/// Mapping of positions of the device to those of the base, from one tick on.
struct DeviceMapping {
    Vector3 device = Vector3::Zero();  ///< of one tick [m]
    Vector3 base = Vector3::Zero();    ///< of the same one, world [m]
    double positionGain = 1.0;         ///< base displacement per device displacement

    /// Returns where the device must be for the base to be at `position` [m].
    [[nodiscard]] Vector3 deviceFor(const Vector3& position) const {
        return device + (position - base) / positionGain;
    }
};

/// Turns what mouse and keyboard ask for into a position for the device, once a frame.
class DevicePilot {
public:
    explicit DevicePilot(Vector3 start) : target_(std::move(start)) {}

    /// The mouse moved the device by so much [m]. Ends a journey.
    void displace(const Vector3& displacement);
    /// Keys are held that move the device so fast [m/s]. A velocity ends a journey.
    void setVelocity(const Vector3& velocity);
    /// The base shall go this way, world; also when the gain changes on the way.
    void follow(DevicePath journey);
    /// Present target of the device [m].
    [[nodiscard]] const Vector3& target() const noexcept { return target_; }
    [[nodiscard]] bool traveling() const noexcept { return !journey_.empty(); }
    /// Keeps the target along the sample near the device, which cannot follow any faster.
    /// @param position of the device [m] @param most distance [m]
    void keepNear(const Vector3& position, double most);

    /// Returns the target of the device after a frame of this duration. @param seconds of the frame
    Vector3 advance(double seconds, const DeviceMapping& mapping);

private:
    Vector3 target_;                      ///< [m]
    Vector3 velocity_ = Vector3::Zero();  ///< [m/s]
    DevicePath journey_;
    double journeyTime_ = 0.0;  ///< [s]
};

/// Returns the height to which steps of a wheel bring the tip: near the sample they all have one
/// length, away from it they grow with the distance, so that a few of them lead from far away to
/// the contact and none passes through the sample at once. As many steps back lead to where they
/// began.
/// @param height   of the tip above first contact, below 0 in contact [m]
/// @param notches  of the wheel, up positive; parts of one count
/// @param fineStep one notch near the sample, > 0 [m]
/// @return the new height [m]
[[nodiscard]] double liftedHeight(double height, double notches, double fineStep) noexcept;

/// One notch near the sample: a part of what the view shows, but in a wide view no more than moves
/// a lever in contact by a fifth of the setpoint, or a tenth of a nanometer [m].
/// @param halfWidth of the view [m]
/// @param setpoint  [N]
/// @param stiffness of the lever [N/m]
[[nodiscard]] double fineLiftStep(double halfWidth, double setpoint, double stiffness) noexcept;

}  // namespace asperity
