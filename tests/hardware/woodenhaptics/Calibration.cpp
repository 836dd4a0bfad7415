#include "tests/hardware/woodenhaptics/Calibration.h"

#include "tests/hardware/Eventually.h"

namespace asperity::test {

bool waitsForCalibration(const WoodenHaptics& device) { return !device.status().calibrated; }

bool calibrateWhenItWaits(WoodenHaptics& device, const std::function<void()>& speak) {
    const bool waits = eventually([&] {
        speak();
        return waitsForCalibration(device);
    });
    device.calibrate();
    return waits && eventually([&] {
               speak();
               return device.advance(0.0).connected;
           });
}

}  // namespace asperity::test
