#include "hardware/hid/HidapiTransport.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"
#include "tests/hardware/Eventually.h"
#include "tests/hardware/woodenhaptics/ArmPose.h"
#include "tests/hardware/woodenhaptics/Calibration.h"
#include "tests/hardware/woodenhaptics/CoupledTip.h"
#include "tests/hardware/woodenhaptics/CoupledTipChild.h"
#include "tests/hardware/woodenhaptics/VirtualWoodenHaptics.h"
#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <iterator>

namespace asperity::test {
namespace {

using Events = std::vector<MotorEvent>;

/// Returns whether the latest messages all drive the motors.
bool isDriven(const VirtualWoodenHaptics& device) {
    constexpr std::ptrdiff_t kMessages = 10;
    const Events events = device.events();
    return std::ssize(events) >= kMessages &&
           std::all_of(events.end() - kMessages, events.end(),
                       [](MotorEvent event) { return event == MotorEvent::Drive; });
}

/// Returns whether the firmware has heard nothing for so long that it cut the motors.
bool isCut(const VirtualWoodenHaptics& device) {
    const Events events = device.events();
    return !events.empty() && events.back() == MotorEvent::Cut;
}

/// Returns whether anything drove the motors from an event on.
bool droveSince(const VirtualWoodenHaptics& device, std::size_t begin) {
    const Events events = device.events();
    return std::find(events.begin() + static_cast<std::ptrdiff_t>(begin), events.end(),
                     MotorEvent::Drive) != events.end();
}

/// A tip in this process that presses on the sample.
class Unplugged : public ::testing::Test {
protected:
    Unplugged() {
        EXPECT_TRUE(calibrateWhenItWaits(driver));
        tip.loop.start();
    }

    void SetUp() override {
        ASSERT_TRUE(engages());
        ASSERT_TRUE(presses());
        (void)ticks();  // the loop keeps a few seconds only
    }
    bool engages() {
        return eventually([this] {
            tip.resetFault();
            return tip.engaged();
        });
    }
    bool presses() {
        device.moveTo(handleAt(kPressed));
        return eventually([this] {
            tip.resetFault();
            return isDriven(device);
        });
    }
    bool isConnected() { return tip.now().input.device.connected; }
    std::vector<TickSample> ticks() {
        std::vector<TickSample> all;
        tip.loop.drain([&all](const TickSample& sample) { all.push_back(sample); });
        return all;
    }

    VirtualWoodenHaptics device{handleAt(kHigh)};
    HidapiTransport transport;
    WoodenHaptics driver{transport, shippedDevice()};
    CoupledTip tip{driver};
};

TEST_F(Unplugged, TheFirstTickThatKnowsIsAFaultAndFeelsNothing) {
    std::vector<TickSample> all;
    ASSERT_TRUE(eventually([&] { return !(all = ticks()).empty(); })) << "one before it is lost";
    device.unplug();
    ASSERT_TRUE(eventually([this] { return !isConnected(); }));
    std::ranges::move(ticks(), std::back_inserter(all));
    const auto first = std::find_if(all.begin(), all.end(), [](const TickSample& tick) {
        return !tick.input.device.connected;
    });
    ASSERT_NE(first, all.end());
    ASSERT_NE(first, all.begin());
    const Fault before = (first - 1)->output.fault;  // it may have been silent first
    EXPECT_EQ(first->output.fault, before == Fault::None ? Fault::DeviceLost : before);
    EXPECT_EQ(first->output.deviceForce, Vector3::Zero());
}

TEST_F(Unplugged, PluggedInAgainTheMotorsRestUntilAPersonTakesTheFaultBack) {
    device.unplug();
    ASSERT_TRUE(eventually([this] { return isCut(device); }));
    const std::size_t before = device.events().size();
    device.plug();
    ASSERT_TRUE(eventually([&] { return device.events().size() > before + 50; }));
    EXPECT_FALSE(droveSince(device, before));
    EXPECT_FALSE(isConnected()) << "it may have lost its power, and does not know its pose";
    ASSERT_TRUE(eventually([this] { return waitsForCalibration(driver); }));
    driver.calibrate();
    ASSERT_TRUE(eventually([this] { return isConnected(); }));
    const std::size_t calibrated = device.events().size();
    ASSERT_TRUE(eventually([&] { return device.events().size() > calibrated + 50; }));
    EXPECT_FALSE(droveSince(device, before));
    EXPECT_NE(tip.now().output.fault, Fault::None);
    EXPECT_TRUE(engages());
    EXPECT_TRUE(presses());
}

/// A tip in another process that presses on the sample.
class Ended : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(program.readLine(), "engaged");
        device.moveTo(handleAt(kPressed));
        ASSERT_TRUE(eventually([this] { return isDriven(device); }));
    }

    VirtualWoodenHaptics device{handleAt(kHigh)};
    CoupledTipChild program{test::programOfBuild("asperity_coupled_tip_program")};
};

TEST_F(Ended, KilledTheProgramSaysNothingMoreAndTheFirmwareCutsTheMotors) {
    EXPECT_EQ(program.end(SIGKILL), "killed by signal 9");
    ASSERT_TRUE(eventually([this] { return isCut(device); }));
    const Events events = device.events();
    EXPECT_EQ(events[events.size() - 2], MotorEvent::Drive)
        << "until its own time-out the device held the last currents";
}

TEST_F(Ended, ToldToEndTheProgramLetsGo) {
    EXPECT_EQ(program.end(SIGTERM), "exited with 0");
    ASSERT_TRUE(eventually([this] { return isCut(device); }));
    const Events events = device.events();
    EXPECT_EQ(events[events.size() - 2], MotorEvent::Zero);
}

}  // namespace
}  // namespace asperity::test
