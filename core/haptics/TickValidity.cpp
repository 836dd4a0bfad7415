#include "core/haptics/TickValidity.h"

#include "core/contact/laws/LawChoice.h"
#include "core/scene/ContactValidity.h"

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
    const Vector3& closest = out.model.closest.point;
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(out.model.contactRatio, 1.0));
    // A shape goes on beyond the window.
    flags.set(Validity::OutsideScan,
              !out.model.closest.insideScan || !scene.surface.contains(closest.x(), closest.y()));
    flags.set(Validity::FilledPixel, !scene.surface.isMeasured(closest.x(), closest.y()));
    flags.set(Validity::ClosestPointNotFound, !out.model.closest.converged);
    flags.set(Validity::NotInEquilibrium, !out.model.converged || !out.model.contact.solved());
    flags.set(Validity::FrictionLock, out.model.locked);
    flags.set(Validity::ModelContradicted, verdict.modelContradicted);
    flags.set(Validity::EstimateInconsistent, verdict.estimateInconsistent);
    const bool bonded = out.model.contact.branch == ContactBranch::Bonded;
    flags.set(Validity::UncertainPixel,
              bonded && scene.certainty.isUncertain(closest.x(), closest.y()));
    flags.set(Validity::Anisotropic, bonded && out.model.anisotropic);
    flags.set(Validity::NarrowValley, bonded && !out.model.tipFits);
    flags.set(Validity::SeveralContactPoints, out.model.points > 1);
    flags.set(Validity::SearchNotExhaustive, mayMissPoints(out.model.proof));
    if (out.model.contact.contactRadius > 0.0) {
        flags.add(contactValidity(contactModelAt(scene, out.model), out.model.contact,
                                  scene.description.sample.material));
    }
    flags.set(Validity::SnapInAhead, snapsSoon(scene, out.model));
    flags.set(Validity::Implausible, out.estimate.plausibility.excessFriction);
    // At rest friction has no direction, and that the geometry is singular tells nothing.
    flags.set(Validity::SingularGeometry, out.estimate.kind == DecouplingCase::NearSingular &&
                                              out.model.slip.norm() > kSliding);
    return flags;
}

}  // namespace asperity
