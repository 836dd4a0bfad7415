#include "core/haptics/mapping/WorkspaceMapping.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Matrix3 turned(double angle, const Vector3& axis) {
    return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// A device and the position that it commands, which starts at the world's origin.
class MappedDevice {
public:
    MappingSettings settings{.positionGain = 1e-6};  // 1 mm: 1 nm

    MappingStep moveTo(const Vector3& device) {
        MappingStep step = mapDevice({}, device, settings, memory_);
        memory_ = step.memory;
        command_ += step.displacement;
        return step;
    }
    [[nodiscard]] Vector3 command() const { return command_; }

private:
    MappingMemory memory_;
    Vector3 command_ = Vector3::Zero();
};

void expectNear(const Vector3& value, const Vector3& expected, double scale) {
    EXPECT_LT((value - expected).norm(), 1e-12 * scale)
        << value.transpose() << " and not " << expected.transpose();
}

TEST(WorkspaceMapping, WhereTheDeviceIsFirstSeenMovesNothing) {
    MappedDevice mapped;
    EXPECT_EQ(mapped.moveTo({0.1, -0.2, 0.3}).status, MappingStatus::Following);
    EXPECT_EQ(mapped.command(), Vector3::Zero());
}

TEST(WorkspaceMapping, TheCommandFollowsTheDeviceTimesTheGain) {
    MappedDevice mapped;
    mapped.moveTo({0.02, 0.0, 0.0});
    mapped.moveTo({0.021, 0.002, -0.003});
    expectNear(mapped.command(), {1.0_nm, 2.0_nm, -3.0_nm}, 1.0_nm);
}

TEST(WorkspaceMapping, AZoomInMidMotionChangesTheSpeedButNotThePosition) {
    MappedDevice mapped;
    const Vector3 step(0.1e-3, 0.0, -0.2e-3);  // of the device in a tick, far from its origin
    Vector3 device(0.05, 0.05, 0.05);
    Vector3 last = Vector3::Zero();
    mapped.moveTo(device);
    for (int i = 0; i < 400; ++i) {
        mapped.settings.positionGain = 1e-6 * std::exp2(std::sin(0.1 * i) * 5.0);
        device += step;
        mapped.moveTo(device);
        expectNear(mapped.command() - last, mapped.settings.positionGain * step,
                   mapped.settings.positionGain * device.norm());
        last = mapped.command();
    }
}

TEST(WorkspaceMapping, ZoomAndTurnedViewMoveNothingUnderADeviceAtRest) {
    MappedDevice mapped;
    const Vector3 device(0.05, -0.04, 0.03);
    mapped.moveTo(device);
    mapped.settings.positionGain = 1e-3;
    mapped.moveTo(device);
    mapped.settings.axes = turned(1.0, {1.0, 2.0, 3.0});
    mapped.moveTo(device);
    EXPECT_EQ(mapped.command(), Vector3::Zero());
}

TEST(WorkspaceMapping, AClutchedDeviceLeavesTheCommandAndGoesOnFromThere) {
    MappedDevice mapped;
    mapped.moveTo({0.0, 0.0, 0.0});
    mapped.moveTo({0.01, 0.0, 0.0});
    const Vector3 held = mapped.command();
    mapped.settings.clutched = true;
    for (int i = 1; i <= 100; ++i) {
        const MappingStep step = mapped.moveTo({0.01 - 2e-4 * i, 1e-4 * i, 0.0});
        ASSERT_EQ(step.status, MappingStatus::Clutched);
        ASSERT_EQ(mapped.command(), held);
    }
    mapped.settings.clutched = false;
    mapped.moveTo({-0.03, 0.05, 0.02});  // far from the last position with the clutch held
    ASSERT_EQ(mapped.command(), held);
    mapped.moveTo({-0.02, 0.05, 0.02});
    expectNear(mapped.command(), held + Vector3(10.0_nm, 0.0, 0.0), 10.0_nm);
}

TEST(WorkspaceMapping, ClutchingReachesBeyondTheWorkspace) {
    MappedDevice mapped;
    for (int stroke = 0; stroke < 10; ++stroke) {
        mapped.settings.clutched = false;
        mapped.moveTo({-0.05, 0.0, 0.0});
        mapped.moveTo({0.05, 0.0, 0.0});
        mapped.settings.clutched = true;
        mapped.moveTo({0.05, 0.0, 0.0});
        mapped.moveTo({-0.05, 0.0, 0.0});
    }
    expectNear(mapped.command(), {1000.0_nm, 0.0, 0.0}, 1000.0_nm);
}

TEST(WorkspaceMapping, PowerIsTheSameInTheDevicesAxesAndTheWorlds) {
    for (int i = 0; i < 50; ++i) {
        MappedDevice mapped;
        mapped.settings.axes = turned(0.3 * i, {std::cos(i), std::sin(2.0 * i), 0.5});
        const Vector3 velocity(0.1, -0.02 * i, 0.3);
        const Vector3 force(std::sin(i), 1.0, -0.1 * i);
        mapped.moveTo(Vector3::Zero());
        const Vector3 inWorld = mapped.moveTo(velocity).motion;
        const Vector3 felt = forceOnDevice(mapped.settings, force);
        const double scale = force.norm() * velocity.norm();
        EXPECT_NEAR(felt.dot(velocity), force.dot(inWorld), 1e-12 * scale);
        EXPECT_NEAR(felt.norm(), force.norm(), 1e-12 * force.norm());
    }
}

TEST(WorkspaceMapping, TheDeviceFollowsTheScreen) {
    // Looking along +y, z up: the device's own axes. From above: up in the image is a device's
    // rise.
    EXPECT_TRUE(viewAxes(Vector3::UnitX(), Vector3::UnitZ())->isIdentity(1e-15));
    const Matrix3 above = viewAxes(2.0 * Vector3::UnitX(), 3.0 * Vector3::UnitY()).value();
    expectNear(above * Vector3::UnitZ(), Vector3::UnitY(), 1.0);
    expectNear(above * Vector3::UnitY(), -Vector3::UnitZ(), 1.0);
    const Matrix3 skew = viewAxes({1.0, 2.0, 0.0}, {0.3, 0.1, 1.0}).value();
    EXPECT_TRUE(skew.isUnitary(1e-12));
    EXPECT_NEAR(skew.determinant(), 1.0, 1e-12);
    EXPECT_GT(skew.col(2).dot(Vector3(0.3, 0.1, 1.0)), 0.0);
    expectNear(skew.col(0), Vector3(1.0, 2.0, 0.0).normalized(), 1.0);
}

TEST(WorkspaceMapping, AViewWithNoUpHasNoAxes) {
    EXPECT_FALSE(viewAxes(Vector3::UnitX(), -2.0 * Vector3::UnitX()));
    EXPECT_FALSE(viewAxes(Vector3::Zero(), Vector3::UnitZ()));
    EXPECT_FALSE(viewAxes(Vector3::UnitX(), {0.0, kNan, 1.0}));
    EXPECT_FALSE(viewAxes({kInfinity, 0.0, 0.0}, Vector3::UnitZ()));
}

TEST(WorkspaceMapping, ADeviceThatIsNoNumberStopsTheCommandAndDoesNotThrowItAfterwards) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        MappedDevice mapped;
        mapped.moveTo(Vector3::Zero());
        EXPECT_EQ(mapped.moveTo({0.0, bad, 0.0}).status, MappingStatus::Invalid);
        EXPECT_EQ(mapped.moveTo({0.1, 0.1, 0.1}).status, MappingStatus::Following);
        EXPECT_EQ(mapped.command(), Vector3::Zero());
    }
}

TEST(WorkspaceMapping, RefusesGainsAndAxesThatAreNone) {
    for (const double gain : {0.0, -1e-6, kNan, kInfinity}) {
        EXPECT_EQ(mapDevice({}, Vector3::Zero(), {.positionGain = gain}, {}).status,
                  MappingStatus::Invalid);
    }
    const Matrix3 mirror = Vector3(-1.0, 1.0, 1.0).asDiagonal();
    const Matrix3 none = Matrix3::Constant(kNan);
    for (const Matrix3& axes : {Matrix3(2.0 * Matrix3::Identity()), mirror, none}) {
        EXPECT_EQ(mapDevice({}, Vector3::Zero(), {.axes = axes}, {}).status,
                  MappingStatus::Invalid);
    }
}

TEST(WorkspaceMapping, ATurnGoesTheShortestWayAndNoFartherThanItMay) {
    const Vector3 from(0.0, 0.0, 3.0);
    const Vector3 wanted(0.0, 0.0, -3.0);  // 0.28 rad on, past the half turn
    const Vector3 next = turnedTowards(from, wanted, 0.1);
    const Eigen::AngleAxisd gone(axesOf(from).transpose() * axesOf(next));
    EXPECT_NEAR(gone.angle(), 0.1, 1e-9);
    const Eigen::AngleAxisd left(axesOf(next).transpose() * axesOf(wanted));
    EXPECT_NEAR(left.angle(), 2.0 * (std::numbers::pi - 3.0) - 0.1, 1e-9);
    EXPECT_EQ(turnedTowards(from, wanted, 0.3), wanted);
}

}  // namespace
}  // namespace asperity
