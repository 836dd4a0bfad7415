#include "tests/hardware/woodenhaptics/ArmPose.h"

#include "core/io/scene/DeviceFiles.h"
#include "tests/support/Places.h"

#include <cmath>
#include <filesystem>
#include <numbers>

namespace asperity::test {

namespace {

/// Angles of the joints; the elbow is away from the operator.
Vector3 anglesAt(const Vector3& fromBase) {
    const auto& [a, b, c] = shippedDevice().joints;
    const double reach = std::hypot(fromBase.x(), fromBase.y());
    const double height = fromBase.z() - a.length;
    const double distance = std::hypot(reach, height);
    const double elevation = std::atan2(reach, height);  // of the handle seen from joint b
    const auto cornerAt = [&](double near, double far) {
        return std::acos((near * near + distance * distance - far * far) / (2.0 * near * distance));
    };
    return {std::atan2(fromBase.y(), fromBase.x()), elevation - cornerAt(b.length, c.length),
            std::numbers::pi - elevation - cornerAt(c.length, b.length)};
}

}  // namespace

const WoodenHapticsDescription& shippedDevice() {
    static const WoodenHapticsDescription device =
        readWoodenHaptics(test::dataFolder() / "devices/woodenhaptics_2015.toml");
    return device;
}

EncoderCounts countsAt(const Vector3& position) {
    const WoodenHapticsDescription& device = shippedDevice();
    const Vector3 angles = anglesAt(inDeviceFrame(position) + device.origin);
    EncoderCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double turns = angles[static_cast<Eigen::Index>(i)] / (2.0 * std::numbers::pi);
        counts[i] = static_cast<std::int16_t>(
            std::lround(turns * device.countsPerTurn / device.joints[i].reduction()));
    }
    return counts;
}

}  // namespace asperity::test
