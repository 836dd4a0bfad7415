#include "core/haptics/mapping/WorkspaceMapping.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kRotationAccuracy = 1e-9;   // of unit length and right angles
constexpr double kMaxEdgeStiffness = 200.0;  // [N/m]
constexpr double kEdgeDamping = 0.3;         // that the delay may take [N s/m]
constexpr double kEdgeForce = 2.0;           // [N]
constexpr double kParallel = 1e-6;           // sine of the angle between right and up [1]

bool isRotation(const Matrix3& axes) {
    return axes.allFinite() && axes.isUnitary(kRotationAccuracy) && axes.determinant() > 0.0;
}

bool isValid(const Vector3& device, const MappingSettings& settings) {
    return device.allFinite() && std::isfinite(settings.positionGain) &&
           settings.positionGain > 0.0 && isRotation(settings.axes);
}

bool isValid(const Workspace& workspace, const Vector3& device) {
    return device.allFinite() && workspace.center.allFinite() && std::isfinite(workspace.radius) &&
           std::isfinite(workspace.freeShare) && std::isfinite(workspace.stiffness) &&
           std::isfinite(workspace.forceLimit);
}

}  // namespace

std::optional<Matrix3> viewAxes(const Vector3& right, const Vector3& up) noexcept {
    if (!right.allFinite() || !up.allFinite() || right.isZero(0.0) || up.isZero(0.0)) {
        return std::nullopt;
    }
    const Vector3 x = right / lengthOf(right);
    const Vector3 away = (up / lengthOf(up)).cross(x);
    if (away.norm() < kParallel) {
        return std::nullopt;
    }
    Matrix3 axes;
    axes.col(0) = x;
    axes.col(1) = away.normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

Matrix3 axesOf(const Vector3& turn) noexcept {
    const double angle = lengthOf(turn);
    return angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                       : Matrix3(Matrix3::Identity());
}

Vector3 turnOf(const Matrix3& axes) noexcept {
    const Eigen::AngleAxisd turn(axes);
    return turn.angle() * turn.axis();
}

Vector3 turnedTowards(const Vector3& turn, const Vector3& wanted, double most) noexcept {
    const Eigen::Quaterniond from(axesOf(turn));
    const Eigen::Quaterniond to(axesOf(wanted));
    const double way = from.angularDistance(to);
    return way > most ? turnOf(from.slerp(most / way, to).toRotationMatrix()) : wanted;
}

Workspace workspaceOf(double radius, double age) noexcept {
    return {.radius = radius,
            .stiffness = std::min(kMaxEdgeStiffness, kEdgeDamping / age),
            .forceLimit = kEdgeForce};
}

MappingStep mapDevice(const Workspace& workspace, const Vector3& device,
                      const MappingSettings& settings, const MappingMemory& before) noexcept {
    MappingStep step;
    if (!isValid(device, settings)) {
        return step;
    }
    step.status = settings.clutched ? MappingStatus::Clutched : MappingStatus::Following;
    step.edgeForce = edgeForce(workspace, device);
    step.memory = {.device = device, .follows = !settings.clutched};
    if (before.follows && step.memory.follows) {
        step.motion = settings.axes * (device - before.device);
        step.displacement = settings.positionGain * step.motion;
    }
    return step;
}

Vector3 forceOnDevice(const MappingSettings& settings, const Vector3& force) noexcept {
    return settings.axes.transpose() * force;
}

Vector3 edgeForce(const Workspace& workspace, const Vector3& device) noexcept {
    if (!isValid(workspace, device) || !(workspace.radius > 0.0 && workspace.stiffness > 0.0)) {
        return Vector3::Zero();
    }
    const Vector3 way = device - workspace.center;
    const double distance = lengthOf(way);
    const double beyond = distance - workspace.freeShare * workspace.radius;
    if (!(beyond > 0.0 && distance > 0.0)) {
        return Vector3::Zero();
    }
    return softLimited(-workspace.stiffness * beyond * (way / distance), workspace.forceLimit);
}

}  // namespace asperity
