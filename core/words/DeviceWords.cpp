#include "core/words/DeviceWords.h"

namespace asperity {

std::string wordsOf(const DeviceStatus& status) {
    switch (status.problem) {
    case DeviceProblem::NotPluggedIn:
        return "no " + status.driver + " is plugged in";
    case DeviceProblem::NotPermitted:
        return status.path + ": " + kNoPermission;
    case DeviceProblem::NotOpened:
        return status.reason;
    case DeviceProblem::Unplugged:
        return "the " + status.driver + " was unplugged";
    case DeviceProblem::None:
        break;
    }
    if (!status.connected()) {
        return {};
    }
    const std::string device = status.name + " at " + status.path;
    return status.calibrated
               ? device
               : device + ": put the handle into its rest pose, then Device > Calibrate";
}

}  // namespace asperity
