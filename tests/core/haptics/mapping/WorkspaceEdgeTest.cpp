#include "core/haptics/mapping/WorkspaceMapping.h"
#include "tests/support/FloatingPointTraps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {
namespace {

const Workspace kTouch{.center = {0.01, 0.0, -0.02},
                       .radius = 0.08,
                       .freeShare = 0.9,
                       .stiffness = 150.0,
                       .forceLimit = 1.0};
constexpr double kEdge = 0.9 * 0.08;  // [m]
const Vector3 kWayOut = Vector3(2.0, -1.0, 2.0) / 3.0;

Vector3 forceAt(double distance) { return edgeForce(kTouch, kTouch.center + distance * kWayOut); }

TEST(WorkspaceEdge, NoForceWithinTheFreeShare) {
    for (const double distance : {0.0, 0.3 * kEdge, (1.0 - 1e-12) * kEdge}) {
        EXPECT_EQ(forceAt(distance), Vector3::Zero()) << distance;
    }
}

TEST(WorkspaceEdge, BeginsWithNoStepAndWithItsStiffness) {
    for (const double beyond : {1e-9, 1e-6, 1e-4}) {
        const Vector3 expected = -kTouch.stiffness * beyond * kWayOut;
        EXPECT_LT((forceAt(kEdge + beyond) - expected).norm(),
                  expected.norm() * (1e-6 + expected.squaredNorm()));
    }
}

TEST(WorkspaceEdge, PushesBackEverHarderUpToItsLimit) {
    double last = 0.0;
    for (const double beyond : {1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 1.0}) {
        const Vector3 force = forceAt(kEdge + beyond);
        EXPECT_NEAR(force.dot(kWayOut), -force.norm(), 1e-12);
        EXPECT_GT(force.norm(), last);
        EXPECT_LT(force.norm(), kTouch.forceLimit);
        last = force.norm();
    }
    EXPECT_NEAR(last, kTouch.forceLimit, 1e-3);
}

/// Energy that the spring holds [J]: the integral of f / sqrt(1 + f^2/L^2) over the way.
double storedAt(const Vector3& device) {
    const double beyond = std::max(0.0, (device - kTouch.center).norm() - kEdge);
    const double limit = kTouch.forceLimit;
    return limit * limit / kTouch.stiffness *
           (std::hypot(1.0, kTouch.stiffness * beyond / limit) - 1.0);
}

TEST(WorkspaceEdge, IsTheGradientOfAnEnergy) {
    constexpr double kStep = 1e-6;
    for (int i = 0; i < 20; ++i) {
        const Vector3 device = 0.09 * Vector3(std::sin(i), std::cos(1.3 * i), std::sin(2.1 * i));
        Vector3 slope;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3 along = kStep * Vector3::Unit(axis);
            slope[axis] = (storedAt(device + along) - storedAt(device - along)) / (2.0 * kStep);
        }
        EXPECT_LT((edgeForce(kTouch, device) + slope).norm(), 1e-6) << device.transpose();
    }
}

TEST(WorkspaceEdge, ActsOnAClutchedDeviceToo) {
    const Vector3 device = kTouch.center + 0.1 * kWayOut;
    const MappingStep step = mapDevice(kTouch, device, {.clutched = true}, {});
    EXPECT_EQ(step.edgeForce, edgeForce(kTouch, device));
    EXPECT_GT(step.edgeForce.norm(), 0.5);
}

TEST(WorkspaceEdge, PushesInTheDevicesAxesWhateverTheView) {
    const MappingSettings turned{
        .axes = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vector3::UnitZ()).toRotationMatrix()};
    const Vector3 device = kTouch.center + 0.1 * kWayOut;
    EXPECT_EQ(mapDevice(kTouch, device, turned, {}).edgeForce,
              mapDevice(kTouch, device, {}, {}).edgeForce);
}

TEST(WorkspaceEdge, AWorkspaceThatNobodyKnowsHasNoEdge) {
    const Vector3 far(10.0, 0.0, 0.0);
    EXPECT_EQ(edgeForce({.stiffness = 100.0, .forceLimit = 1.0}, far), Vector3::Zero());
    EXPECT_EQ(edgeForce({.radius = 0.1, .forceLimit = 1.0}, far), Vector3::Zero());
    EXPECT_EQ(edgeForce({.radius = 0.1, .stiffness = 100.0}, far), Vector3::Zero());
}

TEST(WorkspaceEdge, KeepsItsLimitAtAnyDistance) {
    const test::FloatingPointTraps traps;
    for (const double distance : {1e3, 1e100, 1e200}) {
        EXPECT_NEAR(forceAt(distance).norm(), kTouch.forceLimit, 1e-6);
    }
}

TEST(WorkspaceEdge, NoForceFromWhatIsNoNumber) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity}) {
        Workspace broken = kTouch;
        broken.stiffness = bad;
        EXPECT_EQ(edgeForce(broken, {1.0, 0.0, 0.0}), Vector3::Zero());
        EXPECT_EQ(edgeForce(kTouch, {1.0, bad, 0.0}), Vector3::Zero());
    }
}

}  // namespace
}  // namespace asperity
