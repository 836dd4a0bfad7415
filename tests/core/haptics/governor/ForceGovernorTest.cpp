#include "core/haptics/governor/ForceGovernor.h"

#include "tests/core/haptics/TestDevice.h"
#include "tests/support/DoubleLimits.h"

#include <gtest/gtest.h>

#include <random>

namespace asperity {
namespace {

using test::kInfinity;
using test::kNan;
using test::kTick;

/// A device of 5 N that streams, under the default limits, of which 3 N is the least.
TickInput motors() {
    TickInput input;
    input.device.maxForce = 5.0;
    input.device.streams = true;
    input.timeStep = kTick;
    return input;
}

/// A force that acts fully, at a device that rests in the origin.
GovernorMemory engaged() { return {.share = 1.0, .speed = {.started = true}}; }

ForceRequest wanting(double newtons) { return {.force = {0.0, 0.0, newtons}}; }

GovernedForce govern(const TickInput& input, const ForceRequest& request) {
    return governForce(input, request, engaged());
}

TEST(ForceGovernor, PassesWhatIsWantedUnchangedInNormalRunning) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> newtons(-1.7, 1.7);
    GovernorMemory memory = engaged();
    for (int i = 0; i < 1000; ++i) {
        const ForceRequest request{.force = {newtons(random), newtons(random), newtons(random)}};
        const GovernedForce governed = governForce(motors(), request, memory);
        ASSERT_EQ(governed.force, request.force);
        ASSERT_EQ(governed.state, ForceState::On);
        memory = governed.memory;
    }
}

TEST(ForceGovernor, AValueThatIsNotFiniteIsAFault) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        TickInput position = motors();
        position.device.position.y() = bad;
        TickInput age = motors();
        age.device.age = bad;
        TickInput motor = motors();
        motor.device.maxForce = bad;
        TickInput limit = motors();
        limit.settings.governor.maxForce = bad;
        for (const TickInput& input : {position, age, motor, limit}) {
            EXPECT_EQ(govern(input, wanting(1.0)).fault, Fault::NotFinite);
            EXPECT_EQ(govern(input, wanting(1.0)).force, Vector3::Zero());
        }
        EXPECT_EQ(govern(motors(), wanting(bad)).fault, Fault::NotFinite);
        EXPECT_EQ(govern(motors(), wanting(bad)).force, Vector3::Zero());
        EXPECT_EQ(govern(motors(), wanting(bad)).memory.share, 0.0);
        EXPECT_EQ(govern(motors(), {.mismatch = bad}).fault, Fault::NotFinite);
    }
}

TEST(ForceGovernor, SaturationKeepsTheDirection) {
    std::mt19937 random(3);
    std::normal_distribution<double> component;
    for (int i = 0; i < 100; ++i) {
        const Vector3 direction =
            Vector3(component(random), component(random), component(random)).normalized();
        for (const double newtons : {3.0001, 30.0, 1e200}) {
            const GovernedForce governed = govern(motors(), {.force = newtons * direction});
            EXPECT_NEAR(governed.force.norm(), 3.0, 3e-12);
            EXPECT_LE((governed.force - 3.0 * direction).norm(), 3e-12);
            EXPECT_EQ(governed.state, ForceState::Limited);
            EXPECT_EQ(governed.fault, Fault::None);
        }
    }
    EXPECT_EQ(govern(motors(), wanting(-2.9999)).force.z(), -2.9999);
    EXPECT_EQ(govern(motors(), wanting(-2.9999)).state, ForceState::On);
}

TEST(ForceGovernor, TheWeakerOfDeviceAndSceneSetsTheLimit) {
    TickInput input = motors();
    input.settings.governor.maxForce = 20.0;
    EXPECT_NEAR(govern(input, wanting(30.0)).force.z(), 5.0, 1e-12);
    input.device.maxForce = 0.5;
    EXPECT_NEAR(govern(input, wanting(30.0)).force.z(), 0.5, 1e-12);
}

TEST(ForceGovernor, ComesOnLinearlyInItsTimeAndNeverAboveWhatIsWanted) {
    TickInput input = motors();
    GovernorMemory memory;
    for (const double time : {0.5, 1.0, 2.0}) {
        input.settings.governor.engageTime = time;
        memory = {};
        for (int i = 1; i <= 1000.0 * time + 1; ++i) {
            const double wanted = i == 1 ? 0.1 : 2.0;
            const GovernedForce governed = governForce(input, wanting(wanted), memory);
            ASSERT_NEAR(governed.force.z(), std::min(1.0, i * kTick / time) * wanted, 1e-9);
            ASSERT_LE(governed.force.z(), wanted);
            memory = governed.memory;
        }
        EXPECT_EQ(memory.share, 1.0);
    }
}

TEST(ForceGovernor, SaysThatTheForceWaitsComesOnAndIsOn) {
    EXPECT_EQ(governForce(motors(), wanting(1.0), {}).state, ForceState::Waiting);
    EXPECT_EQ(governForce(motors(), wanting(0.1), {}).state, ForceState::Engaging);
    EXPECT_EQ(governForce(motors(), wanting(2.0), {.share = 0.5}).state, ForceState::Engaging);
    EXPECT_EQ(governForce(motors(), wanting(2.0), {.share = 1.0}).state, ForceState::On);
}

TEST(ForceGovernor, BeginsToActOnlyWithASmallForceAProxyNearTheDeviceAndASlowDevice) {
    const double small = kSmallShare * 3.0;
    const double below = small * (1.0 - 1e-12);
    const double above = small * (1.0 + 1e-12);
    const auto begins = [](const ForceRequest& request, double speed) {
        const GovernorMemory memory{.speed = {.started = true, .speed = speed}};
        return governForce(motors(), request, memory).memory.share > 0.0;
    };
    EXPECT_TRUE(begins(wanting(-below), 0.0));
    EXPECT_FALSE(begins(wanting(-above), 0.0));
    EXPECT_TRUE(begins({.mismatch = below}, 0.0));
    EXPECT_FALSE(begins({.mismatch = above}, 0.0));
    EXPECT_TRUE(begins({}, 1.5));
    EXPECT_FALSE(begins({}, 1.5001));
}

TEST(ForceGovernor, AStallBringsTheForceOnNoFasterThanTenMillisecondsDo) {
    TickInput input = motors();
    input.timeStep = 0.7;
    EXPECT_NEAR(governForce(input, wanting(2.0), {.share = 0.5}).memory.share, 0.51, 1e-12);
}

TEST(ForceGovernor, AReleasedDeadManSwitchTakesTheForceAndIsNoFault) {
    TickInput input = motors();
    input.settings.governor.deadManButton = 31;
    input.device.buttons = 0x80000000U;
    EXPECT_EQ(govern(input, wanting(1.0)).force.z(), 1.0);
    input.device.buttons = 0x7fffffffU;
    const GovernedForce released = govern(input, wanting(1.0));
    EXPECT_EQ(released.force, Vector3::Zero());
    EXPECT_EQ(released.state, ForceState::Released);
    EXPECT_EQ(released.fault, Fault::None);
    input.device.buttons = 0x80000000U;
    const GovernedForce again = governForce(input, wanting(0.2), released.memory);
    EXPECT_NEAR(again.force.z(), 0.2 * kTick, 1e-12) << "held again, it comes on";
}

TEST(ForceGovernor, SilenceFadesTheForceAndThenIsAFault) {
    TickInput input = motors();
    const auto at = [&input](double age) {
        input.device.age = age;
        return govern(input, wanting(2.0));
    };
    EXPECT_EQ(at(10e-3).force.z(), 2.0);
    EXPECT_EQ(at(10e-3).state, ForceState::On);
    EXPECT_LT(at(10.1e-3).force.z(), 2.0);
    EXPECT_EQ(at(10.1e-3).state, ForceState::Fading);
    EXPECT_NEAR(at(25e-3).force.z(), 1.0, 1e-12);
    EXPECT_GT(at(39.9e-3).force.z(), 0.0);
    EXPECT_EQ(at(39.9e-3).fault, Fault::None);
    EXPECT_EQ(at(40e-3).force.z(), 0.0);
    EXPECT_EQ(at(40e-3).fault, Fault::DeviceSilent);
}

TEST(ForceGovernor, AfterAMomentOfSilenceTheForceComesOnFromWhereItFadedTo) {
    TickInput input = motors();
    input.device.age = 16e-3;
    const GovernorMemory faded = govern(input, wanting(2.0)).memory;
    EXPECT_NEAR(faded.share, 0.8, 1e-12);
    input.device.age = 0.0;
    const GovernedForce after = governForce(input, wanting(2.0), faded);
    EXPECT_NEAR(after.memory.share, 0.8 + kTick, 1e-12);
    EXPECT_EQ(after.state, ForceState::Engaging);
}

TEST(ForceGovernor, ADeviceThatReportsOnChangeOnlyMayBeSilent) {
    TickInput input = motors();
    input.device.streams = false;
    input.device.age = 3600.0;
    EXPECT_EQ(govern(input, wanting(2.0)).force.z(), 2.0);
}

TEST(ForceGovernor, ADeviceFasterThanItsLimitIsAFaultWhileTheForceActs) {
    TickInput input = motors();
    input.timeStep = 2e-3;
    input.device.position.x() = 1.499 * input.timeStep;
    EXPECT_EQ(govern(input, wanting(1.0)).fault, Fault::None);
    input.device.position.x() = 1.501 * input.timeStep;
    EXPECT_EQ(govern(input, wanting(1.0)).fault, Fault::VelocityTrip);
    EXPECT_EQ(govern(input, wanting(1.0)).force, Vector3::Zero());
    const GovernorMemory off{.speed = {.started = true}};
    EXPECT_EQ(governForce(input, wanting(1.0), off).fault, Fault::None) << "no force, no runaway";
}

TEST(ForceGovernor, TheFirstReasonStays) {
    TickInput input = motors();
    input.device.age = 1.0;
    for (const Fault first : {Fault::NotFinite, Fault::DeviceLost, Fault::VelocityTrip}) {
        EXPECT_EQ(govern(input, {.fault = first}).fault, first);
        EXPECT_EQ(govern(input, {.force = {kNan, 0.0, 0.0}, .fault = first}).fault, first);
    }
}

TEST(ForceGovernor, ForcesOffTakeTheForceInTheSameTickAndItComesOnAnew) {
    TickInput input = motors();
    input.settings.forcesOn = false;
    const GovernedForce off = govern(input, wanting(1.0));
    EXPECT_EQ(off.force, Vector3::Zero());
    EXPECT_EQ(off.state, ForceState::Off);
    input.settings.forcesOn = true;
    EXPECT_EQ(governForce(input, wanting(1.0), off.memory).state, ForceState::Waiting);
    EXPECT_EQ(governForce(input, wanting(0.1), off.memory).state, ForceState::Engaging);
}

TEST(ForceGovernor, AStartOfTheLoopBringsTheForceOnAnew) {
    TickInput input = motors();
    input.timeStep = 2e-3;
    input.starts = 1;
    const GovernedForce first = govern(input, wanting(0.2));
    EXPECT_NEAR(first.force.z(), 0.2 * input.timeStep, 1e-12);
    input.device.position.x() = 1.0;
    EXPECT_EQ(governForce(input, wanting(0.2), first.memory).fault, Fault::VelocityTrip);
    input.starts = 2;
    EXPECT_EQ(governForce(input, wanting(0.2), first.memory).fault, Fault::None)
        << "where another hand was says nothing of the speed of this one";
}

TEST(ForceGovernor, ADeviceThatOnlySensesGetsWhatIsWantedOrNothing) {
    TickInput input;
    input.device.streams = true;
    input.device.age = 1.0;
    input.settings.governor.deadManButton = 0;
    const GovernedForce passed = governForce(input, wanting(1e9), {});
    EXPECT_EQ(passed.force.z(), 1e9);
    EXPECT_EQ(passed.state, ForceState::On);
    input.settings.forcesOn = false;
    EXPECT_EQ(governForce(input, wanting(1e9), {}).force, Vector3::Zero());
    EXPECT_EQ(governForce(input, wanting(1e9), {}).state, ForceState::Off);
    EXPECT_EQ(governForce(input, {.force = {1.0, 0.0, 0.0}, .fault = Fault::DeviceLost}, {}).force,
              Vector3::Zero());
}

}  // namespace
}  // namespace asperity
