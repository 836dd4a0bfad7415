#include "core/haptics/ZFeedback.h"

#include "core/Units.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "tests/support/HeldLine.h"
#include "tests/support/ShippedScene.h"
#include "tests/support/TestScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace asperity {
namespace {

constexpr double kFeedbackTick = 1e-3;  // [s]
constexpr double kLever = 14.0;         // [N/m]
constexpr double kHeldForce = 5e-9;     // [N]
const FeedbackPlan kHeld{
    .setpoint = kHeldForce, .stiffness = kLever, .lowest = -1e-6, .highest = 1e-6};

/// Errors of a feedback, force over setpoint and stiffness [m], on a sample that does not give in.
/// @param heightAt height at which the force is the setpoint, of the tick [m]
template <class Height>
std::vector<double> errorsOn(const Height& heightAt, double gain, int ticks, double scale = 1.0) {
    FeedbackPlan plan = kHeld;
    plan.setpoint *= scale;
    plan.stiffness *= scale;
    ZFeedback feedback(plan);
    double height = heightAt(0);
    std::vector<double> errors;
    for (int i = 0; i < ticks; ++i) {
        errors.push_back(heightAt(i) - height);
        height = feedback.advance(kFeedbackTick, plan.setpoint + plan.stiffness * errors.back(),
                                  height, gain, true);
    }
    return errors;
}

/// The closed form of its header.
TEST(ZFeedback, ASlopeLeavesNoError) {
    constexpr double kRise = 0.1e-9;  // in a tick [m]
    for (const double gain : {0.2, 0.5, 0.9}) {
        // The first step has not moved yet, and learns nothing.
        const auto slope = [&](int i) { return kRise * std::max(i - 2, 0); };
        const std::vector<double> errors = errorsOn(slope, gain, 200);
        const double pole = std::sqrt(1.0 - gain);
        for (int n = 1; n < 100; ++n) {
            EXPECT_NEAR(errors[n + 2], kRise * n * std::pow(pole, n - 1), 1e-9 * kRise)
                << gain << " " << n;
        }
        EXPECT_NEAR(errors.back(), 0.0, 1e-6 * kRise);
    }
}

TEST(ZFeedback, ScalesWithForces) {
    const auto hills = [](int i) { return 1e-10 * std::sin(0.1 * i); };
    const std::vector<double> plain = errorsOn(hills, 0.5, 300);
    const std::vector<double> scaled = errorsOn(hills, 0.5, 300, 1024.0);
    EXPECT_EQ(plain, scaled);
}

TEST(ZFeedback, DescendsWhereTheContactIsLostAndSaysSo) {
    ZFeedback feedback(kHeld);
    double height = 0.0;
    for (int i = 0; i < 99; ++i) {
        height = feedback.advance(kFeedbackTick, 0.0, height, 0.5, true);
        EXPECT_EQ(feedback.state(), FeedbackState::Holding) << i;
    }
    // By the proportional part alone: no slope is learned from air.
    EXPECT_NEAR(height, -99 * 0.5 * kHeldForce / kLever, 1e-15);
    for (int i = 0; i < 3; ++i) {
        height = feedback.advance(kFeedbackTick, 0.0, height, 0.5, true);
    }
    EXPECT_EQ(feedback.state(), FeedbackState::ContactLost);
    (void)feedback.advance(kFeedbackTick, kHeldForce, height, 0.5, true);
    EXPECT_EQ(feedback.state(), FeedbackState::Holding);
}

TEST(ZFeedback, StaysInItsRangeAndSaysSo) {
    for (const double force : {0.0, 1e-6}) {
        ZFeedback feedback(kHeld);
        double height = 0.0;
        for (int i = 0; i < 10'000; ++i) {
            height = feedback.advance(kFeedbackTick, force, height, 0.5, true);
        }
        EXPECT_EQ(feedback.state(), FeedbackState::RangeLeft);
        EXPECT_EQ(height, force == 0.0 ? kHeld.lowest : kHeld.highest);
    }
}

/// A clutch: the device moves, the base does not.
TEST(ZFeedback, LearnsNothingWhileTheBaseDoesNotFollow) {
    ZFeedback feedback(kHeld);
    constexpr double kError = 1e-10;  // [m]
    double next = 0.0;
    for (int i = 0; i < 1000; ++i) {
        next = feedback.advance(kFeedbackTick, kHeldForce + kLever * kError, 0.0, 0.5, true);
    }
    EXPECT_NEAR(next, 0.5 * kError, 1e-6 * kError);
}

TEST(ZFeedback, CountsFromTheFreeForce) {
    FeedbackPlan plan = kHeld;
    plan.freeForce = -2e-9;
    ZFeedback feedback(plan);
    EXPECT_EQ(feedback.advance(kFeedbackTick, 3e-9, 1e-9, 0.5, true), 1e-9);
    EXPECT_EQ(feedback.error(), 0.0);
}

Scene filmScene() { return sceneOnSample(readScene(test::shippedScene("granular_film"))).scene; }

/// Of the force that the bending shows [N].
double rmsError(const Scene& scene, const std::vector<TickSample>& line, double setpoint) {
    const Vector3 axis = bendingAxis(scene.belief.cantilever);
    double squares = 0.0;
    for (const TickSample& sample : line) {
        squares += std::pow(axis.dot(sample.output.estimate.force) - setpoint, 2);
    }
    return std::sqrt(squares / static_cast<double>(line.size()));
}

TEST(FeedbackDevice, HoldsTheSetpointAlongTheGranularFilm) {
    const Scene scene = filmScene();
    const test::HeldLine line =
        test::heldLine(scene, {0.4 * scene.surface.sizeX(), 0.5 * scene.surface.sizeY()},
                       {.length = 100.0_nm, .speed = 100e-9}, kHeldForce);
    EXPECT_EQ(line.state, FeedbackState::Holding);
    EXPECT_LT(rmsError(scene, line.samples, kHeldForce), 0.05 * kHeldForce);
}

/// On a wall one tick's delay costs stiffness times speed times slope over rate.
TEST(FeedbackDevice, OvershootsAWallByLittleMoreThanOneTicksDelay) {
    for (const double speed : {50e-9, 100e-9, 200e-9}) {
        SceneDescription description = test::plainScene();
        description.signalSigma = 1e-12;
        description.truth.signalNoise = 0.0;
        const Scene scene = buildScene(description, test::ridgedMap(4.0_nm));
        const test::HeldLine line = test::heldLine(scene, {30.0_nm, 60.0_nm},
                                                   {.length = 60.0_nm, .speed = speed}, kHeldForce);
        const Vector3 axis = bendingAxis(scene.belief.cantilever);
        const double step = speed * scene.timeStep();
        double slope = 0.0;
        double force = 0.0;
        for (const TickSample& sample : line.samples) {
            force = std::max(force, axis.dot(sample.output.estimate.force));
        }
        for (double x = 30.0_nm; x < 90.0_nm; x += step) {
            slope = std::max(slope, std::abs(touchHeight(scene, x + step, 60.0_nm) -
                                             touchHeight(scene, x, 60.0_nm)) /
                                        step);
        }
        const double stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2);
        EXPECT_GT(slope, 0.4);
        EXPECT_LT(force - kHeldForce, 3.0 * stiffness * speed * slope * scene.timeStep()) << speed;
    }
}

TEST(FeedbackDevice, TheRecordedInputReplaysToTheSameBits) {
    const Scene scene = buildScene(test::plainScene(), test::hillyMap());
    const test::HeldLine line =
        test::heldLine(scene, {40.0_nm, 60.0_nm}, {.length = 40.0_nm, .speed = 100e-9}, kHeldForce);
    TickMemory memory;
    for (const TickSample& sample : line.all) {
        const TickOutput replayed = tick(scene, sample.input, memory);
        ASSERT_EQ(replayed.estimate.force, sample.output.estimate.force) << sample.time;
        ASSERT_EQ(replayed.base.position, sample.output.base.position) << sample.time;
    }
}

TEST(FeedbackDevice, ARunWithAPositionGainHoldsAsWell) {
    SceneDescription description = test::plainScene();
    description.settings.positionGain = 1e-3;
    const Scene scene = buildScene(description, test::hillyMap());
    const test::HeldLine line =
        test::heldLine(scene, {40.0_nm, 60.0_nm}, {.length = 40.0_nm, .speed = 100e-9}, kHeldForce);
    EXPECT_LT(rmsError(scene, line.samples, kHeldForce), 0.05 * kHeldForce);
    EXPECT_NEAR(line.samples.back().output.base.position.x(), 40.0_nm, 0.2_nm) << "to and fro";
}

TEST(FeedbackDevice, APathEndsForGoodWhereTheContactIsLost) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const Vector3 above(40.0_nm, 60.0_nm, touchHeight(scene, 40.0_nm, 60.0_nm) + 200.0_nm);
    FeedbackDevice device(
        std::make_unique<ScriptedDevice>(linesPath(above, {.length = 60.0_nm, .speed = 60e-9}),
                                         scene.settings.positionGain),
        {.setpoint = kHeldForce, .stiffness = kLever, .lowest = -1e-6, .highest = 1e-6}, above.z(),
        scene.settings.positionGain);
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    Vector3 last = above;
    runVirtually(scene, device, afm, 4001,
                 [&](const TickSample& sample) { last = sample.output.base.position; });
    EXPECT_TRUE(device.hasStopped());
    EXPECT_EQ(device.state(), FeedbackState::Holding) << "it has found the sample again";
    EXPECT_LT(last.x() - above.x(), 60e-9 * 1.2 * ZFeedback::kContactTimeout);
}

/// However fast the mouse is: a drag across ridges presses no more than the wait allows.
TEST(FeedbackDevice, AFastDragAcrossAWallWaitsForTheFeedback) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(8.0_nm));
    const double gain = scene.settings.positionGain;
    const double stiffness = 1.0 / scene.belief.cantilever.compliance()(2, 2);
    const double touch = touchHeight(scene, 30.0_nm, 60.0_nm);
    const Vector3 base(30.0_nm, 60.0_nm, touch - kHeldForce / stiffness);
    auto pointer = std::make_unique<PointerDevice>(base / gain);
    PointerDevice& mouse = *pointer;
    FeedbackDevice device(
        std::move(pointer),
        {.setpoint = kHeldForce, .stiffness = stiffness, .lowest = -1e-6, .highest = 1e-6},
        base.z(), gain);
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    double strongest = 0.0;
    runVirtually(scene, device, afm, 3001, [&](const TickSample& sample) {
        if (sample.time > 0.5) {
            mouse.moveTo((base + Vector3(60.0_nm, 0.0, -50.0_nm)) / gain);
            strongest = std::max(strongest, sample.output.model.force.z());
        }
    });
    EXPECT_LT(strongest, 3.0 * kHeldForce);
    EXPECT_EQ(device.state(), FeedbackState::Holding);
}

TEST(ZFeedback, ItsRangeReachesAboveAllAndBelowTheLowest) {
    const Scene scene = buildScene(test::plainScene(), test::ridgedMap(8.0_nm));
    const Vector3 base(30.0_nm, 60.0_nm, 0.0);
    const FeedbackPlan plan = planFeedback(scene, base, kHeldForce, 1e-10);
    EXPECT_EQ(plan.freeForce, 1e-10);
    EXPECT_GT(plan.highest, waitingPosition(scene, {15.0_nm, 60.0_nm}).z());
    EXPECT_LT(plan.lowest,
              touchHeight(scene, 45.0_nm, 60.0_nm) - expectedDepth(scene, base, kHeldForce));
}

/// On rubber a step of the setpoint rang for half a second, up to 37 % beyond.
TEST(FeedbackDevice, AnotherSetpointIsReachedWithoutRinging) {
    for (const double modulus : {2e9, 1e6}) {
        SceneDescription description = test::plainScene();
        description.sample.material.elastic = {.youngsModulus = modulus, .poissonRatio = 0.45};
        description.sample.material.workOfAdhesion = 0.02;
        description.truth.material = description.sample.material;
        description.signalSigma = 1e-12;
        description.truth.signalNoise = 0.0;
        const Scene scene = buildScene(description, test::flatMap());
        const Vector3 above(60.0_nm, 60.0_nm, touchHeight(scene, 60.0_nm, 60.0_nm));
        const Vector3 base = above - expectedDepth(scene, above, kHeldForce) * Vector3::UnitZ();
        const double gain = scene.settings.positionGain;
        FeedbackDevice device(std::make_unique<PointerDevice>(base / gain),
                              planFeedback(scene, above, kHeldForce, 0.0), base.z(), gain);
        SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
        double strongest = 0.0;
        double last = 0.0;
        runVirtually(scene, device, afm, 8001, [&](const TickSample& sample) {
            if (sample.time >= 2.0) {
                device.hold(2.0 * kHeldForce, kDefaultFeedbackGain);
            }
            last = sample.output.model.force.z();
            strongest = std::max(strongest, last);
        });
        EXPECT_NEAR(last, 2.0 * kHeldForce, 0.02 * kHeldForce) << modulus;
        EXPECT_LT(strongest, 2.1 * kHeldForce) << modulus;
    }
}

/// At rest the noise moved the base, and with it friction turned at each tick.
TEST(FeedbackDevice, AtRestTheBaseHardlyMovesByNoise) {
    const Scene scene = buildScene(test::plainScene(), test::flatMap());
    const test::HeldLine line =
        test::heldLine(scene, {40.0_nm, 60.0_nm}, {.length = 1.0_nm, .speed = 10e-9}, kHeldForce);
    constexpr std::size_t kBegin = 300;  // the line begins after 500 ticks
    constexpr std::size_t kEnd = 499;
    double largest = 0.0;
    double sum = 0.0;
    for (std::size_t i = kBegin; i < kEnd; ++i) {
        const TickOutput& out = line.all[i].output;
        largest = std::max(
            largest, std::abs(out.base.position.z() - line.all[i - 1].output.base.position.z()));
        sum += out.model.force.z();
    }
    EXPECT_LT(largest, 1e-12) << "0.65 of an error of the noise were 30 pm";
    EXPECT_NEAR(sum / (kEnd - kBegin), kHeldForce, 0.02 * kHeldForce);
}

}  // namespace
}  // namespace asperity
