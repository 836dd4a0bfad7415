#include "core/haptics/coupling/ScaleGuard.h"

#include "core/SiFormat.h"
#include "core/haptics/coupling/CouplingDesign.h"

#include <limits>

namespace asperity {

namespace {

std::string newtonsPerMetre(double stiffness) { return formatSi(stiffness, "N/m"); }

std::string sentenceFor(const ScaleJudgement& judged) {
    const std::string remedy = ": a smaller force gain or a larger position gain is needed";
    if (!(judged.felt <= judged.feltBound)) {
        return "the hand would feel " + newtonsPerMetre(judged.felt) +
               ", more than the device renders (" + newtonsPerMetre(judged.feltBound) + ")" +
               remedy;
    }
    if (!(judged.contact <= judged.contactBound)) {
        return "the contact is " + newtonsPerMetre(judged.contact) +
               " at the hand, more than the coupling bears at this rate (" +
               newtonsPerMetre(judged.contactBound) + ")" + remedy;
    }
    return "the hand feels " + newtonsPerMetre(judged.felt) + " of the " +
           newtonsPerMetre(judged.contact) + " of the scaled contact; the device renders " +
           newtonsPerMetre(judged.feltBound);
}

}  // namespace

double inSeries(double first, double second) noexcept { return 1.0 / (1.0 / first + 1.0 / second); }

ScaleJudgement judgeScale(double tipStiffness, const HandScale& scale,
                          const std::optional<CouplingGains>& coupling,
                          const StiffnessBounds& bounds) {
    const double contact = tipStiffness * scale.forceGain * scale.positionGain;
    ScaleJudgement judged{.contact = contact,
                          .contactBound = coupling ? stiffestContact(*coupling, bounds.timeStep)
                                                   : std::numeric_limits<double>::infinity(),
                          .felt = coupling ? inSeries(contact, coupling->stiffness) : contact,
                          .feltBound = bounds.device};
    judged.sentence = sentenceFor(judged);
    return judged;
}

}  // namespace asperity
