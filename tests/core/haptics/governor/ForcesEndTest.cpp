#include "core/Units.h"
#include "core/haptics/HapticLoop.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

namespace asperity {
namespace {

/// A device with motors, held still with the tip a little in the sample.
class MotorDevice final : public HapticDevice {
public:
    explicit MotorDevice(const Vector3& position) : position_(position) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0};
    }
    DeviceState advance(double /*timeStep*/) noexcept override { return {.position = position_}; }
    void setForce(const Vector3& force) noexcept override { newest = force.norm(); }

    std::atomic<double> newest{0.0};  ///< [N]

private:
    Vector3 position_;
};

/// A loop whose operator feels a force.
class ForcesEnd : public ::testing::Test {
protected:
    ForcesEnd() : loop(std::make_unique<HapticLoop>(scene, device, afm)) { startAndFeel(); }

    void startAndFeel() {
        loop->start();
        while (!(device.newest > 0.0)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    /// How much of the wanted force acts.
    [[nodiscard]] static double share(const TickSample& sample) {
        return sample.output.deviceForce.norm() / sample.output.model.force.norm();
    }

    Scene scene = buildScene(test::plainScene(), test::flatMap());
    MotorDevice device{Vector3(64.0_nm, 64.0_nm, -2.0_nm)};
    SimulatedAfm afm{scene.surface, truthOf(scene)};
    std::unique_ptr<HapticLoop> loop;
};

TEST_F(ForcesEnd, WhenTheLoopStops) {
    loop->stop();
    EXPECT_EQ(device.newest, 0.0);
}

TEST_F(ForcesEnd, WhenTheLoopIsDestroyed) {
    loop.reset();
    EXPECT_EQ(device.newest, 0.0);
}

TEST_F(ForcesEnd, ForTheDeviceThatAnotherOneTakesOverFrom) {
    MotorDevice other(Vector3(64.0_nm, 64.0_nm, -2.0_nm));
    loop->stop();
    loop->setDevice(other);
    loop->start();
    while (!(other.newest > 0.0)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(device.newest, 0.0);
    loop.reset();  // before its device goes
    EXPECT_EQ(other.newest, 0.0);
}

TEST_F(ForcesEnd, AndComeOnAnewAfterAPause) {
    while (share(loop->snapshot().sample) < 0.05) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    loop->stop();
    loop->drain([](const TickSample&) {});
    startAndFeel();
    loop->stop();
    std::vector<TickSample> samples;
    loop->drain([&](const TickSample& sample) { samples.push_back(sample); });
    EXPECT_LE(share(samples.front()), 0.011) << "at most one step of it";
    EXPECT_EQ(samples.front().output.forceState, ForceState::Engaging);
}

}  // namespace
}  // namespace asperity
