#include "core/words/DeviceWords.h"

#include "core/SiFormat.h"

namespace asperity {

namespace {

constexpr const char* kForceRemedy = ": reduce the force gain";
constexpr const char* kStiffnessRemedy = ": reduce the force gain or the position gain";

std::string newtonsPerMeter(double stiffness) { return formatSi(stiffness, "N/m"); }

std::string contactRefusal(const ScaleJudgment& judgment) {
    const std::string bound = "(" + newtonsPerMeter(judgment.contactBound) + ")";
    if (judgment.guided && judgment.contactBound < 0.0) {
        return "the guide alone exceeds the stability limit of the coupling at this rate: a "
               "softer guide is needed";
    }
    return "contact stiffness at the device of " + newtonsPerMeter(judgment.contact) +
           " exceeds the stability limit of the coupling at this rate " +
           (judgment.guided ? "beside the guide " : "") + bound + kStiffnessRemedy;
}

}  // namespace

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

std::string refusalOf(const ScaleJudgment& judgment) {
    if (!(judgment.felt <= judgment.feltBound)) {
        return "rendered stiffness of " + newtonsPerMeter(judgment.felt) +
               " exceeds the limit of the device (" + newtonsPerMeter(judgment.feltBound) + ")" +
               kStiffnessRemedy;
    }
    if (!(judgment.contact <= judgment.contactBound)) {
        return contactRefusal(judgment);
    }
    if (!(judgment.adhesion <= judgment.forceBound)) {
        return "adhesion at the device of " + formatSi(judgment.adhesion, "N") +
               " exceeds its force limit (" + formatSi(judgment.forceBound, "N") + ")" +
               kForceRemedy;
    }
    return {};
}

std::string refusalOf(const CoupledDevice& device) {
    return device.noCoupling.empty() ? refusalOf(device.judgment) : device.noCoupling;
}

std::string feltWords(const DeviceScale& scale, const ScaleJudgment& judgment) {
    return "1 mm : " + formatSi(1e-3 * scale.positionGain, "m") +
           ", 1 N : " + formatSi(1.0 / scale.forceGain, "N") + "; stiffness at the device " +
           newtonsPerMeter(judgment.felt) + " of " + newtonsPerMeter(judgment.contact);
}

}  // namespace asperity
