#include "core/haptics/TickValidity.h"

#include "core/scene/TipValidity.h"

namespace asperity {

namespace {

constexpr double kSnapInMargin = 1e-9;  // [m]
constexpr double kSnapInWatch = 20e-9;  // [m]: no tip snaps in across a wider gap
constexpr double kSliding = 0.5;        // weight of the slip direction from which it counts

/// Whether a separate tip is about to snap in on a lever as soft as this one.
bool snapsSoon(const Scene& scene, const TipState& model) {
    const ContactState& contact = model.contact;
    if (contact.branch != ContactBranch::Far || contact.indentation < -kSnapInWatch) {
        return false;
    }
    const double compliance =
        model.closest.normal.dot(scene.belief.cantilever.compliance() * model.closest.normal);
    const ContactModel law = contactModelAt(scene, model);
    const double jumpIn = law.jumpInApproach(compliance);
    const double now = contact.indentation + (compliance * contact.force);
    return jumpIn - now < kSnapInMargin && law.pullOffApproach(compliance) < jumpIn;
}

}  // namespace

ValidityFlags tickValidity(const Scene& scene, const TickOutput& out,
                           const InnovationVerdict& verdict) noexcept {
    ValidityFlags flags =
        tipValidity(scene, scene.belief, scene.description.sample.material, out.model);
    flags.set(Validity::ModelContradicted, verdict.modelContradicted);
    flags.set(Validity::EstimateInconsistent, verdict.estimateInconsistent);
    flags.set(Validity::SnapInAhead, snapsSoon(scene, out.model));
    flags.set(Validity::Implausible, out.estimate.plausibility.excessFriction);
    // At rest friction has no direction, and that the geometry is singular tells nothing.
    flags.set(Validity::SingularGeometry, out.estimate.kind == DecouplingCase::NearSingular &&
                                              out.model.slip.norm() > kSliding);
    return flags;
}

}  // namespace asperity
