#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include <cmath>
#include <numbers>

namespace asperity {

Vector3 jointAngles(const WoodenHapticsDescription& device, const EncoderCounts& counts) noexcept {
    Vector3 angles;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double motor = 2.0 * std::numbers::pi * counts[i] / device.countsPerTurn;
        angles[static_cast<Eigen::Index>(i)] = motor * device.joints[i].reduction();
    }
    return angles;
}

Vector3 handlePosition(const WoodenHapticsDescription& device, const Vector3& angles) noexcept {
    const auto& [a, b, c] = device.joints;
    const double reach = b.length * std::sin(angles[1]) + c.length * std::sin(angles[2]);
    const double height =
        a.length + b.length * std::cos(angles[1]) - c.length * std::cos(angles[2]);
    return Vector3(std::cos(angles[0]) * reach, std::sin(angles[0]) * reach, height) -
           device.origin;
}

Vector3 jointTorques(const WoodenHapticsDescription& device, const Vector3& angles,
                     const Vector3& force) noexcept {
    const double lengthB = device.joints[1].length;
    const double lengthC = device.joints[2].length;
    const double reach = lengthB * std::sin(angles[1]) + lengthC * std::sin(angles[2]);
    const double outward = std::cos(angles[0]) * force.x() + std::sin(angles[0]) * force.y();
    const double sideways = std::cos(angles[0]) * force.y() - std::sin(angles[0]) * force.x();
    return {reach * sideways,
            lengthB * (std::cos(angles[1]) * outward - std::sin(angles[1]) * force.z()),
            lengthC * (std::cos(angles[2]) * outward + std::sin(angles[2]) * force.z())};
}

Vector3 motorCurrents(const WoodenHapticsDescription& device, const Vector3& torques) noexcept {
    if (!torques.allFinite()) {
        return Vector3::Zero();
    }
    const auto& [a, b, c] = device.joints;
    const Vector3 reductions(a.reduction(), b.reduction(), c.reduction());
    const Vector3 currents = torques.cwiseProduct(reductions) / device.motorConstant;
    const double largest = currents.cwiseAbs().maxCoeff();
    return largest > device.maxCurrent ? Vector3((device.maxCurrent / largest) * currents)
                                       : currents;
}

Vector3 inLabFrame(const Vector3& inDevice) noexcept {
    return {inDevice.y(), -inDevice.x(), inDevice.z()};
}

Vector3 inDeviceFrame(const Vector3& inLab) noexcept { return {-inLab.y(), inLab.x(), inLab.z()}; }

}  // namespace asperity
