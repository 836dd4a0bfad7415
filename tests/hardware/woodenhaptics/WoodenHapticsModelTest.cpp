#include "hardware/woodenhaptics/WoodenHapticsModel.h"

#include "tests/hardware/woodenhaptics/ArmPose.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <vector>

namespace asperity::test {
namespace {

const std::vector<Vector3> kPoses = {
    {0.0, 0.0, 0.5 * std::numbers::pi}, {0.4, 0.3, 1.2}, {-0.7, -0.5, 2.1}, {1.9, 0.9, 0.2}};
const Vector3 kHandleForce(0.7, -1.1, 0.4);  // [N]

/// Derivatives of the handle's position by each of the joints' angles, one a column.
Matrix3 numericalJacobian(const Vector3& angles) {
    constexpr double kStep = 1e-5;  // [rad]
    Matrix3 jacobian;
    for (int joint = 0; joint < 3; ++joint) {
        const Vector3 step = kStep * Vector3::Unit(joint);
        jacobian.col(joint) = (handlePosition(shippedDevice(), angles + step) -
                               handlePosition(shippedDevice(), angles - step)) /
                              (2.0 * kStep);
    }
    return jacobian;
}

TEST(WoodenHapticsModel, AtZeroAnglesTheForearmHangsBesideTheUpperArm) {
    const Vector3 position = handlePosition(shippedDevice(), Vector3::Zero());
    EXPECT_TRUE(position.isApprox(Vector3(-0.22, 0.0, 0.08 + 0.205 - 0.245 - 0.08), 1e-12));
}

TEST(WoodenHapticsModel, InTheRestPoseTheForearmPointsToThePerson) {
    const auto& [a, b, c] = shippedDevice().joints;
    const Vector3 angles = jointAngles(shippedDevice(), {a.restCounts, b.restCounts, c.restCounts});
    EXPECT_TRUE(angles.isApprox(Vector3(0.0, 0.0, 0.5 * std::numbers::pi), 1e-12));
    EXPECT_TRUE(handlePosition(shippedDevice(), angles)
                    .isApprox(Vector3(0.245 - 0.22, 0.0, 0.08 + 0.205 - 0.08), 1e-12));
}

TEST(WoodenHapticsModel, ATurnOfTheMotorTurnsTheJointByTheRatioOfTheDiameters) {
    const Vector3 angles = jointAngles(shippedDevice(), {2000, -2000, 1000});
    const double turn = 2.0 * std::numbers::pi;
    EXPECT_TRUE(angles.isApprox(Vector3(turn / 16.0, -turn / 12.0, turn / 24.0), 1e-12));
}

TEST(WoodenHapticsModel, ThePositionIsWhereTheLawOfCosinesPutsTheHandle) {
    for (const Vector3& position :
         {Vector3(0.0, 0.0, 0.0), Vector3(0.05, 0.03, -0.02), Vector3(-0.06, 0.05, 0.04)}) {
        const Vector3 angles = jointAngles(shippedDevice(), countsAt(position));
        const Vector3 found = inLabFrame(handlePosition(shippedDevice(), angles));
        EXPECT_LT((found - position).norm(), 0.1e-3) << "a count moves the handle by 0.06 mm";
    }
}

TEST(WoodenHapticsModel, TorqueIsTheTransposedJacobianTimesTheForce) {
    for (const Vector3& angles : kPoses) {
        const Vector3 expected = numericalJacobian(angles).transpose() * kHandleForce;
        EXPECT_LT((jointTorques(shippedDevice(), angles, kHandleForce) - expected).norm(),
                  1e-8 * expected.norm());
    }
}

TEST(WoodenHapticsModel, WhatTheMotorsGiveTheDeviceTakes) {
    WoodenHapticsDescription device = shippedDevice();
    device.joints[1].sign = -1.0;
    device.maxCurrent = 30.0;
    const EncoderCounts counts = {500, -900, 4100};
    const Vector3 speeds(0.31, -0.17, 0.23);  // of the motors [turn/s]
    const Vector3 currents =
        motorCurrents(device, jointTorques(device, jointAngles(device, counts), kHandleForce));
    const double electric =
        device.motorConstant * currents.dot(2.0 * std::numbers::pi * speeds);  // [W]

    // Counts are whole: a motor turn of 2000 is the step, and the angles are linear in it.
    const Vector3 angles = jointAngles(device, counts);
    const Vector3 perTurn = jointAngles(device, {2000, 2000, 2000});
    constexpr double kTime = 1e-5;  // [s]
    const Vector3 motion = kTime * speeds.cwiseProduct(perTurn);
    const Vector3 velocity =
        (handlePosition(device, angles + motion) - handlePosition(device, angles - motion)) /
        (2.0 * kTime);
    EXPECT_NEAR(electric, kHandleForce.dot(velocity), 1e-8 * std::abs(electric));
}

TEST(WoodenHapticsModel, TheAmplifiersLimitKeepsTheDirectionOfTheForce) {
    const Vector3 angles = kPoses[1];
    const Vector3 free =
        motorCurrents(shippedDevice(), jointTorques(shippedDevice(), angles, 0.1 * kHandleForce));
    const Vector3 held =
        motorCurrents(shippedDevice(), jointTorques(shippedDevice(), angles, 100.0 * kHandleForce));
    EXPECT_LT(free.cwiseAbs().maxCoeff(), shippedDevice().maxCurrent);
    EXPECT_NEAR(held.cwiseAbs().maxCoeff(), shippedDevice().maxCurrent, 1e-12);
    EXPECT_TRUE(held.normalized().isApprox(free.normalized(), 1e-12));
}

TEST(WoodenHapticsModel, TorquesThatAreNotFiniteDriveNoMotor) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(motorCurrents(shippedDevice(), Vector3(0.1, bad, 0.1)), Vector3::Zero());
    }
}

TEST(WoodenHapticsModel, RightOfThePersonIsRightInTheLab) {
    EXPECT_EQ(inLabFrame(Vector3::UnitY()), Vector3::UnitX());
    EXPECT_EQ(inLabFrame(Vector3::UnitX()), Vector3(-Vector3::UnitY())) << "to the person";
    EXPECT_EQ(inLabFrame(Vector3::UnitZ()), Vector3::UnitZ());
    EXPECT_EQ(inDeviceFrame(inLabFrame(kHandleForce)), kHandleForce);
}

}  // namespace
}  // namespace asperity::test
