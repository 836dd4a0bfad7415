/// A program that holds a tip with the first WoodenHaptics that it finds, until SIGTERM ends it.
/// Prints "engaged" once forces are on.

#include "hardware/hid/HidapiTransport.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"
#include "tests/hardware/Eventually.h"
#include "tests/hardware/woodenhaptics/ArmPose.h"
#include "tests/hardware/woodenhaptics/Calibration.h"
#include "tests/hardware/woodenhaptics/CoupledTip.h"

#include <csignal>
#include <iostream>

int main() {
    using namespace asperity;
    using namespace asperity::test;
    sigset_t end{};
    sigemptyset(&end);
    sigaddset(&end, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &end, nullptr);

    HidapiTransport transport;
    WoodenHaptics device(transport, shippedDevice());
    if (!calibrateWhenItWaits(device)) {
        return 1;
    }
    CoupledTip tip(device);
    tip.loop.start();
    const auto engaged = [&tip] {
        tip.resetFault();
        return tip.engaged();
    };
    if (!eventually(engaged)) {
        return 1;
    }
    std::cout << "engaged" << std::endl;
    constexpr timespec kPause = {.tv_sec = 0, .tv_nsec = 1'000'000};
    while (sigtimedwait(&end, nullptr, &kPause) != SIGTERM) {
        tip.resetFault();
    }
    return 0;
}
