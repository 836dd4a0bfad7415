#include "core/haptics/HapticLoop.h"

#include "core/Units.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace asperity {
namespace {

/// Waits until the loop has made this many ticks.
void waitForTicks(HapticLoop& loop, long ticks) {
    while (loop.snapshot().statistics.ticks < ticks) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

/// Its forces come on within two ticks.
Scene flatScene() {
    Scene scene = buildScene(test::plainScene(), test::flatMap());
    scene.settings.governor.engageTime = 1e-3;
    return scene;
}

Vector3 middleAbove(const Scene& scene, double height) {
    const double x = 0.5 * scene.surface.sizeX();
    const double y = 0.5 * scene.surface.sizeY();
    return {x, y, scene.surface.at(x, y).height + height};
}

/// A device that can push back, and be pulled out.
class FakeDevice final : public HapticDevice {
public:
    explicit FakeDevice(const Vector3& position) : position_(position) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return {.maxForce = 5.0};
    }
    DeviceState advance(double /*timeStep*/) noexcept override {
        return {.position = position_, .connected = connected.load()};
    }
    void setForce(const Vector3& force) noexcept override { forceZ = force.z(); }
    void observe(const TickOutput& output) noexcept override {
        seenZ = output.base.position.z();
        ++seen;
    }

    std::atomic<bool> connected{true};
    std::atomic<double> seenZ{0.0};  ///< height of the base in the last tick's output [m]
    std::atomic<long> seen{0};       ///< outputs
    std::atomic<double> forceZ{0.0};

private:
    Vector3 position_;
};

/// One scene, one device, its loop.
struct Bench {
    Scene scene = flatScene();
    FakeDevice device{middleAbove(scene, -2.0_nm)};
    SimulatedAfm afm{scene.surface, truthOf(scene)};
    HapticLoop loop{scene, device, afm};
};

TEST(HapticLoop, AStepIsATickWithoutTheClock) {
    Bench bench;
    bench.loop.step();
    bench.loop.step();
    EXPECT_FALSE(bench.loop.running());
    EXPECT_EQ(bench.loop.snapshot().statistics.ticks, 2);
    EXPECT_EQ(bench.loop.snapshot().sample.output.base.position, middleAbove(bench.scene, -2.0_nm));
    std::vector<double> times;
    bench.loop.drain([&times](const TickSample& sample) { times.push_back(sample.time); });
    EXPECT_EQ(times, (std::vector<double>{0.0, bench.scene.timeStep()}));
}

TEST(HapticLoop, ADeviceThatTakesOverMovesNothingByWhereItIs) {
    const Scene scene = flatScene();
    const Vector3 position = middleAbove(scene, 20.0_nm);
    FakeDevice first(position / scene.settings.positionGain);
    FakeDevice second(Vector3(0.02, -0.01, 0.03));
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    HapticLoop loop(scene, first, afm);
    loop.step();
    loop.setDevice(second);
    loop.step();
    loop.step();
    EXPECT_LT((loop.snapshot().sample.output.base.position - position).norm(), 1e-15);
}

TEST(HapticLoop, ADeviceSeesWhatEveryTickComputed) {
    Bench bench;
    bench.loop.step();
    bench.loop.step();
    EXPECT_EQ(bench.device.seen, 2);
    EXPECT_EQ(bench.device.seenZ, bench.loop.snapshot().sample.output.base.position.z());
}

TEST(HapticLoop, MakesTheSameTicksAsAVirtualRun) {
    const Scene scene = flatScene();
    const DevicePath path{{0.0, middleAbove(scene, 3.0_nm)}, {0.2, middleAbove(scene, -2.0_nm)}};
    ScriptedDevice device(path, scene.settings.positionGain);
    SimulatedAfm afm(scene.surface, truthOf(scene));
    HapticLoop loop(scene, device, afm);
    loop.start();
    waitForTicks(loop, 250);
    loop.stop();
    std::vector<TickSample> live;
    loop.drain([&live](const TickSample& sample) { live.push_back(sample); });
    ASSERT_GE(live.size(), 250U);

    TickMemory memory;
    for (const TickSample& sample : live) {
        const TickOutput again = tick(scene, sample.input, memory);
        ASSERT_EQ(again.deviceForce, sample.output.deviceForce);
        ASSERT_EQ(again.tip, sample.output.tip);
        const Vector3 wanted = positionAt(path, sample.time);
        ASSERT_NEAR((sample.output.base.position - wanted).norm(), 0.0, 1e-18);
    }
    EXPECT_EQ(live.back().output.region(), TipRegion::Contact);
}

TEST(HapticLoop, TimeIsThatOfTheSteps) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 100);
    bench.loop.stop();
    double time = 0.0;
    long ticks = 0;
    bench.loop.drain([&](const TickSample& sample) {
        time += ticks++ == 0 ? 0.0 : sample.input.timeStep;
        EXPECT_NEAR(sample.time, time, 1e-12);
        const double periods = sample.input.timeStep / bench.scene.timeStep();
        EXPECT_NEAR(periods, std::round(periods), 1e-9);
    });
    const LoopStatistics& statistics = bench.loop.snapshot().statistics;
    EXPECT_EQ(ticks, statistics.ticks);
    EXPECT_EQ(statistics.lostSamples, 0);
}

TEST(HapticLoop, PushesTheDeviceAndLetsGoWhenStopped) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 50);
    EXPECT_GT(bench.device.forceZ, 1e-9);
    bench.loop.stop();
    EXPECT_EQ(bench.device.forceZ, 0.0);
}

TEST(HapticLoop, GoesOnWhereItStopped) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 20);
    bench.loop.stop();
    const Snapshot before = bench.loop.snapshot();
    bench.loop.start();
    waitForTicks(bench.loop, before.statistics.ticks + 1);
    bench.loop.stop();
    std::vector<TickSample> all;
    bench.loop.drain([&all](const TickSample& sample) { all.push_back(sample); });
    const auto at = static_cast<std::size_t>(before.statistics.ticks);
    ASSERT_GT(all.size(), at);
    EXPECT_NEAR(all[at].time - all[at - 1].time, all[at].input.timeStep, 1e-12);
    EXPECT_EQ(all[at].output.region(), TipRegion::Contact);
    EXPECT_LT(all[at].output.base.velocity.norm(), 1e-20);
}

TEST(HapticLoop, TurnsKnobsWhileItRuns) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 50);
    const double force = bench.device.forceZ;
    Settings settings = bench.scene.settings;
    settings.forceGain = 10.0;
    bench.loop.setSettings(settings);
    waitForTicks(bench.loop, bench.loop.snapshot().statistics.ticks + 2);
    EXPECT_NEAR(bench.device.forceZ, 10.0 * force, 0.5 * force);
    settings.forcesOn = false;
    bench.loop.setSettings(settings);
    waitForTicks(bench.loop, bench.loop.snapshot().statistics.ticks + 2);
    EXPECT_EQ(bench.device.forceZ, 0.0);
}

TEST(HapticLoop, ALostDeviceFeelsNothingUntilAPersonTakesItBack) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 20);
    bench.device.connected = false;
    waitForTicks(bench.loop, bench.loop.snapshot().statistics.ticks + 2);
    EXPECT_EQ(bench.loop.snapshot().sample.output.fault, Fault::DeviceLost);
    EXPECT_EQ(bench.device.forceZ, 0.0);
    bench.device.connected = true;
    waitForTicks(bench.loop, bench.loop.snapshot().statistics.ticks + 2);
    EXPECT_EQ(bench.loop.snapshot().sample.output.fault, Fault::DeviceLost);
    Settings settings = bench.scene.settings;
    settings.rearms = 1;
    bench.loop.setSettings(settings);
    waitForTicks(bench.loop, bench.loop.snapshot().statistics.ticks + 2);
    EXPECT_EQ(bench.loop.snapshot().sample.output.fault, Fault::None);
    EXPECT_GT(bench.device.forceZ, 1e-9);
}

TEST(HapticLoop, CountsSamplesThatNobodyFetched) {
    SceneDescription description = test::plainScene();
    description.tickRate = 10000.0;
    const Scene scene = buildScene(description, test::flatMap());
    FakeDevice device(middleAbove(scene, 1.0_nm));
    SimulatedAfm afm(scene.surface, truthOf(scene));
    HapticLoop loop(scene, device, afm);
    loop.start();
    while (loop.snapshot().statistics.lostSamples == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    loop.stop();
    long fetched = 0;
    loop.drain([&fetched](const TickSample&) { ++fetched; });
    const LoopStatistics& statistics = loop.snapshot().statistics;
    EXPECT_EQ(fetched + statistics.lostSamples, statistics.ticks);
}

TEST(HapticLoop, TellsHowItKeepsTimeOnceASecond) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 1010);
    const LoopStatistics statistics = bench.loop.snapshot().statistics;
    EXPECT_GT(statistics.tickTime.median, 0.0);
    EXPECT_LE(statistics.tickTime.median, statistics.tickTime.p99);
    EXPECT_LE(statistics.tickTime.p99, statistics.tickTime.largest);
    EXPECT_GT(statistics.lateness.largest, 0.0);
}

/// A device that holds the loop up once.
class SlowDevice final : public HapticDevice {
public:
    explicit SlowDevice(const Vector3& position) : position_(position) {}
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double /*timeStep*/) noexcept override {
        if (++steps_ == 20) {
            std::this_thread::sleep_for(std::chrono::milliseconds(6));
        }
        return {.position = position_};
    }

private:
    Vector3 position_;
    int steps_ = 0;
};

TEST(HapticLoop, TakesOneLongStepOverWhatItMissed) {
    const Scene scene = flatScene();
    SlowDevice device(middleAbove(scene, 5.0_nm));
    SimulatedAfm afm(scene.surface, truthOf(scene));
    HapticLoop loop(scene, device, afm);
    loop.start();
    waitForTicks(loop, 40);
    loop.stop();
    std::vector<TickSample> samples;
    loop.drain([&samples](const TickSample& sample) { samples.push_back(sample); });
    const double period = scene.timeStep();
    EXPECT_GE(samples[20].input.timeStep, 5.5 * period) << "five due times were slept over";
    long skipped = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        skipped += std::lround(samples[i].input.timeStep / period) - 1;
    }
    EXPECT_EQ(loop.snapshot().statistics.overruns, skipped);
}

TEST(HapticLoop, CountsTimesFromEachStartAnew) {
    Bench bench;
    bench.loop.start();
    waitForTicks(bench.loop, 50);
    bench.loop.stop();
    EXPECT_EQ(bench.loop.times().lateness.count(),
              static_cast<std::uint64_t>(bench.loop.snapshot().statistics.ticks));
    bench.loop.start();
    bench.loop.stop();
    EXPECT_LT(bench.loop.times().lateness.count(), 50U);
}

TEST(HapticLoop, StartsAndStopsOverAndOver) {
    Bench bench;
    for (int i = 0; i < 100; ++i) {
        bench.loop.start();
        bench.loop.stop();
    }
    EXPECT_FALSE(bench.loop.running());
}

TEST(PointerDevice, FollowsItsTargetWithoutOvershoot) {
    PointerDevice device(Vector3::Zero());
    device.moveTo({1.0_nm, 0.0, -2.0_nm});
    double last = 0.0;
    for (int i = 0; i < 500; ++i) {
        const double x = device.advance(1e-3).position.x();
        EXPECT_GE(x, last);
        EXPECT_LE(x, 1.0_nm);
        last = x;
    }
    EXPECT_NEAR(last, 1.0_nm, 1e-6 * 1.0_nm);
}

TEST(PointerDevice, MovesAsFarInOneLongStepAsInManyShortOnes) {
    PointerDevice coarse(Vector3::Zero());
    PointerDevice fine(Vector3::Zero());
    coarse.moveTo({1.0_nm, 0.0, 0.0});
    fine.moveTo({1.0_nm, 0.0, 0.0});
    const double once = coarse.advance(0.05).position.x();
    double often = 0.0;
    for (int i = 0; i < 50; ++i) {
        often = fine.advance(1e-3).position.x();
    }
    EXPECT_NEAR(once, often, 1e-9 * often);
}

TEST(ScriptedDevice, LeadsTheBaseAlongItsPathWhateverTheGain) {
    ScriptedDevice device({{0.0, {0.0, 0.0, 0.0}}, {1.0, {4.0_nm, 0.0, 0.0}}}, 2.0);
    EXPECT_EQ(device.advance(0.5).position.x(), 0.0);
    EXPECT_NEAR(device.advance(0.5).position.x(), 1.0_nm, 1e-18);
    EXPECT_NEAR(device.advance(0.5).position.x(), 2.0_nm, 1e-18);
    EXPECT_NEAR(device.advance(0.5).position.x(), 2.0_nm, 1e-18);
}

TEST(ScriptedDevice, TakesOverFromWhereAnotherDeviceIs) {
    ScriptedDevice device({{0.0, {7.0_nm, 0.0, 0.0}}, {1.0, {9.0_nm, 0.0, 0.0}}}, 2.0,
                          {100.0_nm, 0.0, 0.0});
    EXPECT_EQ(device.advance(0.5).position.x(), 100.0_nm);
    EXPECT_NEAR(device.advance(1.0).position.x(), 101.0_nm, 1e-18);
}

TEST(HapticLoop, PublishesWhereTheSimulatedTipReallyIsBesideTheTick) {
    Bench bench;
    EXPECT_FALSE(bench.loop.snapshot().trueTip);
    bench.loop.step();
    const Snapshot& snapshot = bench.loop.snapshot();
    ASSERT_TRUE(snapshot.trueTip);
    EXPECT_EQ(*snapshot.trueTip, bench.afm.trueState().tip);
    EXPECT_GT(snapshot.trueTip->z(), snapshot.sample.output.base.position.z())
        << "the sample bends the lever up";
}

TEST(HapticLoop, PublishesNoTrueTipOfAnInstrumentThatKnowsNone) {
    class Measuring final : public AfmController {
    public:
        AfmMeasurement exchange(const BaseMotion& /*target*/) noexcept override { return {}; }
    } measuring;
    Bench bench;
    HapticLoop loop(bench.scene, bench.device, measuring);
    loop.step();
    EXPECT_FALSE(loop.snapshot().trueTip);
}

}  // namespace
}  // namespace asperity
