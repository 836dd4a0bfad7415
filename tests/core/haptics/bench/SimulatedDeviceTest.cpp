#include "core/Units.h"
#include "core/haptics/bench/VirtualBench.h"
#include "tests/core/haptics/TestDevice.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asperity {
namespace {

using test::kTick;

constexpr double kResolution = kPhantomClass.resolution;

/// Lets so much time pass. @return where the handle is then
Vector3 after(SimulatedDevice& device, double seconds) {
    Vector3 position = Vector3::Zero();
    for (double time = 0.0; time < seconds; time += kTick) {
        position = device.advance(kTick).position;
    }
    return position;
}

TEST(SimulatedDevice, RestsWhereItStartsToTheEncodersStep) {
    const Vector3 start(1e-3, -2e-3, 5e-3);
    SimulatedDevice device(start);
    EXPECT_LE((after(device, 0.5) - start).cwiseAbs().maxCoeff(), 0.5001 * kResolution);
}

TEST(SimulatedDevice, TheHandleGoesWhereThePointerLeads) {
    SimulatedDevice device(Vector3::Zero());
    const Vector3 target(4e-3, 0.0, -8e-3);
    device.moveTo(target);
    // Joint friction leaves it short by at most 0.04 N over the arm's 150 N/m.
    const double friction = kPhantomClass.coulombFriction / kNormalGrip.stiffness;
    EXPECT_LT((after(device, 1.0) - target).cwiseAbs().maxCoeff(), friction + kResolution);
}

TEST(SimulatedDevice, AForceMovesTheHandleAwayFromThereAgainstTheArm) {
    SimulatedDevice device(Vector3::Zero());
    device.setForce({0.0, 0.0, 1.5});
    const double friction = kPhantomClass.coulombFriction / kNormalGrip.stiffness;
    EXPECT_NEAR(after(device, 1.0).z(), 1.5 / kNormalGrip.stiffness, friction + kResolution);
}

TEST(SimulatedDevice, ThePersonReachesNoFasterThanPeopleDoHoweverFarThePointerJumps) {
    SimulatedDevice device(Vector3::Zero());
    device.moveTo({0.09, 0.0, 0.0});
    double fastest = 0.0;
    double last = 0.0;
    for (int i = 0; i < 1500; i += 10) {
        const double position = after(device, 10 * kTick).x();
        fastest = std::max(fastest, (position - last) / (10 * kTick));
        last = position;
    }
    EXPECT_NEAR(last, 0.09, 1e-3);
    EXPECT_GT(fastest, 0.4);
    EXPECT_LT(fastest, 0.75);
}

TEST(SimulatedDevice, ThePersonReachesNoFartherThanToTheEdgeOfTheWorkspace) {
    SimulatedDevice device(Vector3::Zero());
    device.moveTo({0.5, 0.0, 0.0});
    EXPECT_NEAR(after(device, 3.0).x(), kPhantomClass.workspaceRadius, 1e-3);
}

}  // namespace
}  // namespace asperity
