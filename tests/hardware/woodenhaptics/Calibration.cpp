#include "tests/hardware/woodenhaptics/Calibration.h"

#include "tests/hardware/Eventually.h"

namespace asperity::test {

bool waitsForCalibration(const WoodenHaptics& hand) { return !hand.status().calibrated; }

bool calibrateWhenItWaits(WoodenHaptics& hand, const std::function<void()>& speak) {
    const bool waits = eventually([&] {
        speak();
        return waitsForCalibration(hand);
    });
    hand.calibrate();
    return waits && eventually([&] {
               speak();
               return hand.advance(0.0).connected;
           });
}

}  // namespace asperity::test
