#include "core/words/ScaleWords.h"

#include "core/SiFormat.h"

namespace asperity {

namespace {

constexpr const char* kForceRemedy = ": a smaller force gain is needed";
constexpr const char* kStiffnessRemedy =
    ": a smaller force gain or a smaller position gain is needed";

std::string newtonsPerMeter(double stiffness) { return formatSi(stiffness, "N/m"); }

std::string contactRefusal(const ScaleJudgment& judgment) {
    const std::string bound = "(" + newtonsPerMeter(judgment.contactBound) + ")";
    if (judgment.guided && judgment.contactBound < 0.0) {
        return "the guide alone is stiffer or more damped than the coupling bears at this rate: a "
               "softer guide is needed";
    }
    return "the contact is " + newtonsPerMeter(judgment.contact) +
           " at the hand, more than the coupling bears at this rate " +
           (judgment.guided ? "beside the guide " : "") + bound + kStiffnessRemedy;
}

}  // namespace

std::string refusalOf(const ScaleJudgment& judgment) {
    if (!(judgment.felt <= judgment.feltBound)) {
        return "the hand would feel " + newtonsPerMeter(judgment.felt) +
               ", more than the device renders (" + newtonsPerMeter(judgment.feltBound) + ")" +
               kStiffnessRemedy;
    }
    if (!(judgment.contact <= judgment.contactBound)) {
        return contactRefusal(judgment);
    }
    if (!(judgment.adhesion <= judgment.forceBound)) {
        return "the sample would hold the hand with " + formatSi(judgment.adhesion, "N") +
               ", more than the motors may give (" + formatSi(judgment.forceBound, "N") + ")" +
               kForceRemedy;
    }
    return {};
}

std::string refusalOf(const CoupledDevice& device) {
    return device.noCoupling.empty() ? refusalOf(device.judgment) : device.noCoupling;
}

std::string feltWords(const DeviceScale& scale, const ScaleJudgment& judgment) {
    return "1 mm : " + formatSi(1e-3 * scale.positionGain, "m") +
           ", 1 N : " + formatSi(1.0 / scale.forceGain, "N") + "; the hand feels " +
           newtonsPerMeter(judgment.felt) + " of " + newtonsPerMeter(judgment.contact);
}

}  // namespace asperity
