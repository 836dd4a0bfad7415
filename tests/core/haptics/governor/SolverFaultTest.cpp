#include "core/Units.h"
#include "core/haptics/HapticTick.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Friction so large that the lever locks as long as it is drawn along +x.
Scene lockingScene() {
    SceneDescription description = test::plainScene();
    description.sample.material.friction.coefficient = 9.0;
    return buildScene(description, test::flatMap());
}

/// A tip pressed into the sample by a device with motors, and drawn to and fro.
class Drawn {
public:
    Drawn() {
        input.device.position = {64.0_nm, 64.0_nm, -1.0_nm};
        input.device.maxForce = 5.0;
        input.timeStep = 1e-3;
        input.settings = scene_.settings;
    }

    /// @param step of the device in each tick, along x [m]
    /// @return the last tick
    TickOutput draw(double step, int ticks) {
        TickOutput last;
        for (int i = 0; i < ticks; ++i) {
            input.device.position.x() += step;
            last = tick(scene_, input, memory_);
        }
        return last;
    }

    TickInput input;

private:
    Scene scene_ = lockingScene();
    TickMemory memory_;
};

constexpr double kDrawStep = 0.1_nm;

TEST(SolverFault, IsLatchedAfterFiftyMillisecondsWithoutAnEquilibrium) {
    Drawn tip;
    tip.draw(0.0, 10);
    const TickOutput failing = tip.draw(kDrawStep, 49);
    EXPECT_TRUE(failing.flags.has(Validity::FrictionLock));
    EXPECT_EQ(failing.fault, Fault::None);
    EXPECT_EQ(failing.deviceForce, Vector3::Zero());
    EXPECT_EQ(tip.draw(kDrawStep, 1).fault, Fault::SolverFailed);
    const TickOutput solved = tip.draw(0.0, 100);
    EXPECT_FALSE(solved.flags.has(Validity::FrictionLock));
    EXPECT_EQ(solved.fault, Fault::SolverFailed) << "only a person takes it back";
    ++tip.input.settings.rearms;
    EXPECT_EQ(tip.draw(0.0, 1).fault, Fault::None);
}

TEST(SolverFault, IsNotATransient) {
    Drawn tip;
    tip.draw(0.0, 10);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(tip.draw(kDrawStep, 40).fault, Fault::None);
        EXPECT_EQ(tip.draw(0.0, 1).fault, Fault::None);
    }
}

TEST(SolverFault, IsNotAStallOfTheLoop) {
    Drawn tip;
    tip.draw(0.0, 10);
    tip.input.timeStep = 0.5;
    EXPECT_EQ(tip.draw(kDrawStep, 1).fault, Fault::None);
}

TEST(SolverFault, DoesNotStopADeviceThatOnlySenses) {
    Drawn tip;
    tip.input.device.maxForce = 0.0;
    tip.draw(0.0, 10);
    const TickOutput failing = tip.draw(kDrawStep, 200);
    EXPECT_TRUE(failing.flags.has(Validity::FrictionLock));
    EXPECT_EQ(failing.fault, Fault::None);
    EXPECT_EQ(failing.deviceForce, Vector3::Zero());
}

}  // namespace
}  // namespace asperity
