#include "core/haptics/coupling/ScaleGuard.h"

#include "core/haptics/coupling/CouplingDesign.h"

#include <limits>

namespace asperity {

namespace {

/// What is left for the contact beside a guide, from (K + k) T/2 + b = bp [N/m].
double contactBound(const CouplingGains& gains, const GuideLoad& guide, double timeStep) {
    CouplingGains left = gains;
    left.proxyDamping -= guide.damping;
    return stiffestContact(left, timeStep) - guide.stiffness;
}

}  // namespace

ScaleJudgment judgeScale(const TipLoad& tip, const DeviceScale& scale,
                         const std::optional<CouplingGains>& coupling, const ScaleBounds& bounds,
                         const GuideLoad& guide) {
    const double contact = tip.stiffness * scale.forceGain * scale.positionGain;
    return {.contact = contact,
            .contactBound = coupling ? contactBound(*coupling, guide, bounds.timeStep)
                                     : std::numeric_limits<double>::infinity(),
            .felt = coupling ? inSeries(contact, coupling->stiffness) : contact,
            .feltBound = bounds.stiffness,
            .adhesion = tip.adhesion * scale.forceGain,
            .forceBound = bounds.force,
            .guided = guide.stiffness > 0.0 || guide.damping > 0.0};
}

}  // namespace asperity
