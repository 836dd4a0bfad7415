#include "core/haptics/coupling/ScaleGuard.h"

#include "core/SiFormat.h"
#include "core/haptics/coupling/CouplingDesign.h"

#include <limits>

namespace asperity {

namespace {

constexpr const char* kForceRemedy = ": a smaller force gain is needed";
constexpr const char* kStiffnessRemedy =
    ": a smaller force gain or a smaller position gain is needed";

std::string newtonsPerMeter(double stiffness) { return formatSi(stiffness, "N/m"); }

/// What is left for the contact beside a guide, from (K + k) T/2 + b = bp [N/m].
double contactBound(const CouplingGains& gains, const GuideLoad& guide, double timeStep) {
    CouplingGains left = gains;
    left.proxyDamping -= guide.damping;
    return stiffestContact(left, timeStep) - guide.stiffness;
}

std::string contactRefusal(const ScaleJudgment& judged) {
    const std::string bound = "(" + newtonsPerMeter(judged.contactBound) + ")";
    if (judged.guided && judged.contactBound < 0.0) {
        return "the guide alone is stiffer or more damped than the coupling bears at this rate: a "
               "softer guide is needed";
    }
    return "the contact is " + newtonsPerMeter(judged.contact) +
           " at the hand, more than the coupling bears at this rate " +
           (judged.guided ? "beside the guide " : "") + bound + kStiffnessRemedy;
}

std::string sentenceFor(const ScaleJudgment& judged) {
    if (!(judged.felt <= judged.feltBound)) {
        return "the hand would feel " + newtonsPerMeter(judged.felt) +
               ", more than the device renders (" + newtonsPerMeter(judged.feltBound) + ")" +
               kStiffnessRemedy;
    }
    if (!(judged.contact <= judged.contactBound)) {
        return contactRefusal(judged);
    }
    if (!(judged.adhesion <= judged.forceBound)) {
        return "the sample would hold the hand with " + formatSi(judged.adhesion, "N") +
               ", more than the motors may give (" + formatSi(judged.forceBound, "N") + ")" +
               kForceRemedy;
    }
    return "the hand feels " + newtonsPerMeter(judged.felt) + " of the " +
           newtonsPerMeter(judged.contact) + " of the scaled contact; the device renders " +
           newtonsPerMeter(judged.feltBound);
}

}  // namespace

ScaleJudgment judgeScale(const TipLoad& tip, const DeviceScale& scale,
                         const std::optional<CouplingGains>& coupling, const ScaleBounds& bounds,
                         const GuideLoad& guide) {
    const double contact = tip.stiffness * scale.forceGain * scale.positionGain;
    ScaleJudgment judged{.contact = contact,
                         .contactBound = coupling ? contactBound(*coupling, guide, bounds.timeStep)
                                                  : std::numeric_limits<double>::infinity(),
                         .felt = coupling ? inSeries(contact, coupling->stiffness) : contact,
                         .feltBound = bounds.stiffness,
                         .adhesion = tip.adhesion * scale.forceGain,
                         .forceBound = bounds.force,
                         .guided = guide.stiffness > 0.0 || guide.damping > 0.0};
    judged.sentence = sentenceFor(judged);
    return judged;
}

}  // namespace asperity
