#include "core/scene/TipValidity.h"

#include "core/contact/laws/LawChoice.h"
#include "core/scene/AttractionValidity.h"
#include "core/scene/ContactValidity.h"
#include "core/scene/Scene.h"

namespace asperity {

namespace {

/// By how much of its indentation other contacts may lower one until it is said; about 1.5 times as
/// much of its force.
constexpr double kInteraction = 0.05;

/// What the law of the tip's place does not hold for; nothing where no law acts, which saves making
/// it.
ValidityFlags lawValidity(const ProbeSystem& system, const SampleMaterial& material,
                          const TipState& state) noexcept {
    const ContactState& contact = state.contact;
    const Vector3& normal = state.closest.normal;
    const double compliance = normal.dot(system.cantilever.compliance() * normal);
    const bool touches = contact.contactRadius > 0.0;
    ValidityFlags flags;
    if (!touches && !isPulledByFar(contact, compliance)) {
        return flags;
    }
    const ContactModel model = contactModelAt(system, state);
    if (touches) {
        flags.add(contactValidity(model, contact, material));
    }
    flags.add(attractionValidity(model, contact, compliance, flags.has(Validity::ElasticLimit)));
    return flags;
}

/// All but what takes the topography around the contact.
ValidityFlags quickValidity(const Scene& scene, const ProbeSystem& system,
                            const SampleMaterial& material, const TipState& state) noexcept {
    const Vector3& closest = state.closest.point;
    ValidityFlags flags;
    flags.set(Validity::LargeContact, isLargeContact(state.contactRatio, 1.0));
    // An exact shape goes on beyond the window in which it is drawn.
    const bool isDrawn = scene.surface.contains(closest.x(), closest.y());
    flags.set(Validity::OutsideScan, !state.closest.insideScan || !(isDrawn || scene.shape));
    flags.set(Validity::FilledPixel, !scene.surface.isMeasured(closest.x(), closest.y()));
    flags.set(Validity::ClosestPointNotFound, !state.closest.converged);
    flags.set(Validity::NotInEquilibrium, !state.converged || !state.contact.solved());
    flags.set(Validity::FrictionLock, state.locked);
    const bool bonded = state.contact.branch == ContactBranch::Bonded;
    flags.set(Validity::UncertainPixel,
              bonded && scene.certainty.isUncertain(closest.x(), closest.y()));
    flags.set(Validity::Anisotropic, bonded && state.anisotropic);
    flags.set(Validity::NarrowValley, bonded && !state.tipFits);
    flags.set(Validity::SeveralContactPoints, state.points > 1);
    flags.set(Validity::OverlappingContacts, state.overlapping);
    flags.set(Validity::InteractingContacts, state.interaction > kInteraction);
    flags.set(Validity::SearchNotExhaustive, state.mayLackPoint);
    if (state.contact.contactRadius > 0.0) {
        flags.set(
            Validity::VariedMaterial,
            system.field != nullptr &&
                system.field->variesWithin(closest.x(), closest.y(), state.contact.contactRadius));
    }
    flags.set(Validity::LargeDeflection, system.cantilever.isBentTooFar(state.force));
    flags.add(lawValidity(system, material, state));
    return flags;
}

}  // namespace

ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                          const SampleMaterial& material, const TipState& state) noexcept {
    ValidityFlags flags = quickValidity(scene, system, material, state);
    flags.add(asperityValidity(scene, system, state));
    return flags;
}

ValidityFlags tipValidity(const Scene& scene, const ProbeSystem& system,
                          const SampleMaterial& material, const TipState& state,
                          AsperityMemory& memory) noexcept {
    ValidityFlags flags = quickValidity(scene, system, material, state);
    flags.add(asperityValidity(scene, system, state, memory));
    return flags;
}

}  // namespace asperity
