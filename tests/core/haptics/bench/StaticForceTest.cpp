#include "core/haptics/coupling/CouplingDesign.h"
#include "core/scene/Scene.h"
#include "tests/core/haptics/TestDevice.h"
#include "tests/core/haptics/bench/HeldTip.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <iostream>

namespace asperity {
namespace {

using test::kPhantom;

/// At rest the device force is the sample's force on the tip times the force gain, though base, tip
/// and device are held by three springs in a row.
void expectForceOfTheSample(const std::string& material, const HeightMap& map, double goal,
                            double lift = 0.0) {
    const Scene scene = test::hapticScene(material, map);
    const CouplingGains gains =
        designCoupling(kPhantom, {.timeStep = scene.timeStep(), .delay = BenchSetup{}.delay});
    const test::HeldTip held = test::holdTip(
        scene, {.bench = {.arm = kNormalGrip}, .coupling = gains, .goal = goal, .lift = lift});
    const Vector3 exact = scene.settings.forceGain * held.tipForce;
    ASSERT_GT(exact.norm(), 0.1);
    EXPECT_LT((held.force - exact).norm(), 0.01 * exact.norm()) << held.force.transpose();
    // The arm's spring balances it up to what the joints' friction bears, axis by axis.
    const Vector3 arm = kNormalGrip.stiffness * (Vector3(64e-3, 64e-3, goal + lift) - held.handle);
    EXPECT_LT((held.force + arm).cwiseAbs().maxCoeff(), 1.01 * kPhantomClass.coulombFriction);
    std::cout << material << " at " << (goal + lift) * 1e3 << " mm: " << held.force.transpose()
              << " N of " << exact.transpose() << " N\n";
}

TEST(StaticForce, PressedOnAFlatSample) {
    for (const char* material : {"silicon_oxide", "polystyrene"}) {
        expectForceOfTheSample(material, test::flatMap(), -10e-3);
    }
    expectForceOfTheSample("silicone_rubber", test::flatMap(), -100e-3);
}

TEST(StaticForce, PulledByAdhesion) {
    expectForceOfTheSample("silicon_oxide", test::flatMap(), -3e-3, 10e-3);
}

TEST(StaticForce, HasTheDirectionOfASlopingSample) {
    expectForceOfTheSample("silicon_oxide", test::slopedMap(0.2), -5e-3);
}

}  // namespace
}  // namespace asperity
