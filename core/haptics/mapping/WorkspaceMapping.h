#pragma once

#include "core/Vector.h"
#include "core/scene/Settings.h"

#include <cmath>
#include <optional>

namespace asperity {

/// Length of a vector, where Eigen's norm() would overflow, too.
[[nodiscard]] inline double lengthOf(const Vector3& vector) noexcept {
    return std::hypot(vector.x(), vector.y(), vector.z());
}

/// The force f / sqrt(1 + |f|^2 / limit^2): its direction is that of f, small forces pass nearly
/// unchanged, none is above the limit. It is the gradient of a convex function of f, which is what
/// keeps a spring with a damper passive when their sum is limited; docs/haptics.md.
/// @param force finite [N]
/// @param limit >= 0 [N]; 0: no force
[[nodiscard]] inline Vector3 softLimited(const Vector3& force, double limit) noexcept {
    const double size = lengthOf(force);
    if (!(size > 0.0 && limit > 0.0)) {
        return Vector3::Zero();
    }
    // Takes the form whose quotient is at most 1.
    return size > limit ? Vector3((force / size) * (limit / std::hypot(1.0, limit / size)))
                        : Vector3(force / std::hypot(1.0, size / limit));
}

/// Settings that an operator may change while the loop runs; none moves anything by itself.
struct MappingSettings {
    double positionGain = 1.0;           ///< displacement at the tip per displacement of the device
    Matrix3 axes = Matrix3::Identity();  ///< rotation from the device's axes to the world's
    bool clutched = false;               ///< the device moves, what it commands stays
};

/// State carried from step to step.
struct MappingMemory {
    Vector3 device = Vector3::Zero();  ///< its last position, the device's axes [m]
    bool follows = false;  ///< the device commanded there, so that its next motion counts
};

enum class MappingStatus {
    Following,  ///< the command goes with the device
    Clutched,   ///< it stays, and the operator shall feel no force of the contact
    Invalid,    ///< a value is not finite, a gain not above 0, or the axes are no rotation
};

/// Results of one step.
struct MappingStep {
    MappingStatus status = MappingStatus::Invalid;
    Vector3 motion = Vector3::Zero();        ///< of the device, world axes, its own scale [m]
    Vector3 displacement = Vector3::Zero();  ///< of what it commands, world axes and scale [m]
    Vector3 edgeForce = Vector3::Zero();     ///< of the workspace on the device, device's axes [N]
    MappingMemory memory;
};

/// Axes that go with a view: right, away from the operator and up at the device (its x, y, z) are
/// right, into the picture and up on the screen. In a view from above a hand that rises then moves
/// up in the image, and one that moves away goes down to the sample.
/// @param right, up of the view in world axes, any length; `up` is made orthogonal to `right`
/// @return nothing where these are not finite, zero or parallel
[[nodiscard]] std::optional<Matrix3> viewAxes(const Vector3& right, const Vector3& up) noexcept;

/// Axes as Settings::deviceTurn has them, and back.
[[nodiscard]] Matrix3 axesOf(const Vector3& turn) noexcept;
[[nodiscard]] Vector3 turnOf(const Matrix3& axes) noexcept;

/// On the shortest way from one turn to another, by at most so much [rad].
[[nodiscard]] Vector3 turnedTowards(const Vector3& turn, const Vector3& wanted,
                                    double most) noexcept;

/// From the device to what it commands. The motion since the last step counts if the device
/// commanded at both its ends; it is turned by the axes, and the command moves by it times the
/// gain. So a changed gain or view, a clutch pressed or released, a first step and one after
/// invalid input move nothing by themselves. With a coupling it is `motion` that the proxy follows,
/// and the proxy's own motion times the gain that the command follows. Wait-free.
/// @param device its position, the device's axes [m]
[[nodiscard]] MappingStep mapDevice(const Workspace& workspace, const Vector3& device,
                                    const MappingSettings& settings,
                                    const MappingMemory& before) noexcept;

/// A force in world axes, at the device's scale, as the operator feels it in the device's axes [N]:
/// by the transpose of the axes, so that force times motion is the same power in both.
[[nodiscard]] Vector3 forceOnDevice(const MappingSettings& settings, const Vector3& force) noexcept;

/// The workspace of a device, with a spring that a light grip keeps at rest: nothing but the arm
/// damps it, by 0.5 N s/m at least, and a force of the given age takes k * age of that away
/// (Colgate's bound). k is the lesser of 200 N/m and 0.3 N s/m / age; docs/haptics.md.
/// @param radius in which the handle moves [m]; 0: not known, no spring
/// @param age    of the force that answers a motion: half a tick and the delay [s]
[[nodiscard]] Workspace workspaceOf(double radius, double age) noexcept;

/// Force of the workspace's spring on the device, the device's axes [N]: zero up to the free share
/// of the radius, from there k (r - r0) towards the center, which nears the force limit smoothly.
/// It depends on the position alone: what it takes from a device it gives back. Zero for invalid
/// values.
[[nodiscard]] Vector3 edgeForce(const Workspace& workspace, const Vector3& device) noexcept;

}  // namespace asperity
