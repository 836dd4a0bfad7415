#include "core/haptics/TickValidity.h"

#include "core/scene/Scene.h"
#include "core/scene/TipValidity.h"

#include <cmath>

namespace asperity {

namespace {

// [m]: a notice to the operator, ahead by about what a hand takes a tenth of a second for; no force
// depends on it.
constexpr double kSnapInMargin = 1e-9;
constexpr double kSliding = 0.5;  // weight of the slip direction from which it counts

/// Whether a gap is so wide that the law need not be asked when the tip snaps in: far out of range,
/// on a lever that is hardly bent. At a fold of the attraction it is bent by half of the gap, and
/// where it is bent by a twentieth, with the attraction's square law, that gap is not half as wide.
bool isFarFromSnapIn(const ContactModel& law, const ContactState& contact, double compliance) {
    constexpr double kHardlyBent = 0.05;
    const double gap = -contact.indentation;
    return gap > 2.0 * law.attractionRange() + kSnapInMargin &&
           std::abs(compliance * contact.force) < kHardlyBent * gap;
}

/// Whether the base leaves the sample at its closest point.
bool isWithdrawn(const TickOutput& out) {
    return out.base.velocity.dot(out.model.closest.normal) > 0.0;
}

/// Whether a separate tip that does not leave the sample is about to snap in on a lever as soft as
/// this one.
bool snapsSoon(const Scene& scene, const TickOutput& out) {
    const TipState& model = out.model;
    const ContactState& contact = model.contact;
    if (contact.branch != ContactBranch::Far || isWithdrawn(out)) {
        return false;
    }
    const double compliance =
        model.closest.normal.dot(scene.belief.cantilever.compliance() * model.closest.normal);
    if (isFarFromSnapIn(scene.belief.contact, contact, compliance)) {
        return false;
    }
    const ContactModel law = contactModelAt(scene, model);
    const double jumpIn = law.jumpInApproach(compliance);
    const double now = contact.indentation + (compliance * contact.force);
    return jumpIn - now < kSnapInMargin && law.pullOffApproach(compliance) < jumpIn;
}

}  // namespace

ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                           const InnovationVerdict& verdict, AsperityMemory& memory) noexcept {
    ValidityFlags flags =
        tipValidity(scene, scene.belief, scene.description.sample.material, out.model, memory);
    flags.set(Validity::ModelContradicted, verdict.modelContradicted);
    flags.set(Validity::EstimateInconsistent, verdict.estimateInconsistent);
    flags.set(Validity::SnapInAhead, snapsSoon(scene, out));
    flags.set(Validity::Implausible, out.estimate.plausibility.excessFriction);
    // At rest friction has no direction, and that the geometry is singular tells nothing.
    flags.set(Validity::SingularGeometry, out.estimate.kind == DecouplingCase::NearSingular &&
                                              out.model.slip.norm() > kSliding);
    return flags;
}

}  // namespace asperity
