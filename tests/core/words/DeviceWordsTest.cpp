#include "core/words/DeviceWords.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(DeviceWords, NameTheDeviceAndWhatItWaitsFor) {
    DeviceStatus status{
        .driver = "SpaceMouse", .name = "SpaceMouse Compact", .path = "/dev/hidraw7"};
    EXPECT_EQ(wordsOf(status), "SpaceMouse Compact at /dev/hidraw7");
    status.calibrated = false;
    EXPECT_EQ(wordsOf(status), "SpaceMouse Compact at /dev/hidraw7: put the handle into its rest "
                               "pose, then Device > Calibrate");
    EXPECT_EQ(wordsOf({}), "");
}

TEST(DeviceWords, TellWhyThereIsNone) {
    const auto why = [](DeviceProblem problem) {
        return wordsOf({.problem = problem,
                        .driver = "SpaceMouse",
                        .path = "/dev/hidraw7",
                        .reason = "the device is asleep"});
    };
    EXPECT_EQ(why(DeviceProblem::NotPluggedIn), "no SpaceMouse is plugged in");
    EXPECT_EQ(why(DeviceProblem::Unplugged), "the SpaceMouse was unplugged");
    EXPECT_EQ(why(DeviceProblem::NotOpened), "the device is asleep");
    EXPECT_EQ(why(DeviceProblem::NotPermitted), std::string("/dev/hidraw7: ") + kNoPermission);
}

}  // namespace
}  // namespace asperity
