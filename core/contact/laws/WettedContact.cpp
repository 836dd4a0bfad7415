#include "core/contact/laws/WettedContact.h"

#include "core/contact/ContactState.h"
#include "core/contact/laws/JoinedLaw.h"

#include <algorithm>

namespace asperity {

/// A state of the bare law with the meniscus' force on it.
ContactState WettedContact::wetted(ContactState state) const noexcept {
    const Meniscus& meniscus = model_.given_.options.meniscus;
    const double radius = model_.given_.pair.tipRadius;
    if (state.branch == ContactBranch::Bonded) {
        state.force -= meniscus.pull(radius);
        return state;
    }
    state.force += meniscus.force(radius, state.indentation);
    if (state.indentation > -meniscus.range) {
        state.stiffness -= meniscus.pull(radius) / meniscus.range;
    }
    return state;
}

/// Where the law, or else the water, leaves separate bodies without a stable state.
WettedContact::End WettedContact::endOfSeparate(double compliance) const noexcept {
    const Meniscus& meniscus = model_.given_.options.meniscus;
    const auto jumpIn = [this](double soft) {
        return model_.onJoined([&](const auto& joined) { return joined.jumpInApproach(soft); });
    };
    const double dry = jumpIn(compliance);
    if (model_.bare(dry, compliance, {}).indentation <= -meniscus.range) {
        return {.approach = dry};
    }
    const double moved = compliance * meniscus.pull(model_.given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    if (stiff > 0.0) {
        const double end = jumpIn(compliance / stiff);
        if (model_.bare(end, compliance / stiff, {}).indentation > -meniscus.range) {
            return {.approach = (stiff * end) - moved, .inWater = true, .softApproach = end};
        }
    }
    return {.approach =
                (compliance * model_.bare(-meniscus.range, 0.0, {}).force) - meniscus.range};
}

/// Separate bodies at an approach; none beyond the end of their branch.
std::optional<ContactState> WettedContact::separateAt(double approach,
                                                      double compliance) const noexcept {
    const Meniscus& meniscus = model_.given_.options.meniscus;
    const End end = endOfSeparate(compliance);
    if (approach > end.approach) {
        return std::nullopt;
    }
    const ContactState dry = model_.bare(approach, compliance, {});
    const bool apart = dry.branch == ContactBranch::Far && dry.indentation <= -meniscus.range;
    if (apart || !end.inWater) {
        return dry;
    }
    const double moved = compliance * meniscus.pull(model_.given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    const double held = std::min((approach + moved) / stiff, end.softApproach);
    return wetted(model_.bare(held, compliance / stiff, {}));
}

ContactState WettedContact::bondedAt(double approach, double compliance,
                                     const ContactMemory& memory) const noexcept {
    const double moved =
        compliance * model_.given_.options.meniscus.pull(model_.given_.pair.tipRadius);
    return model_.bare(approach + moved, compliance, memory);
}

/// Energy of bodies, meniscus and lever [J].
double WettedContact::energy(const ContactState& wetted, double compliance) const noexcept {
    const Meniscus& meniscus = model_.given_.options.meniscus;
    const double radius = model_.given_.pair.tipRadius;
    const bool bonded = wetted.branch == ContactBranch::Bonded;
    ContactState dry = wetted;
    dry.force -= bonded ? -meniscus.pull(radius) : meniscus.force(radius, wetted.indentation);
    return model_.onJoined([&](const auto& joined) { return joined.bodyEnergy(dry); }) +
           meniscus.energy(radius, wetted.indentation, bonded) +
           leverEnergy(wetted.force, compliance);
}

ContactState WettedContact::equilibrium(double approach, double compliance,
                                        const ContactMemory& memory) const noexcept {
    const auto far = separateAt(approach, compliance);
    if (memory.branch == ContactBranch::Far) {
        return far ? *far : snappedIn(approach, compliance);
    }
    const ContactState bonded = bondedAt(approach, compliance, memory);
    if (bonded.branch == ContactBranch::Bonded) {
        return wetted(bonded);
    }
    // Where rounding leaves neither branch, the two meet.
    return far ? pulledOff(*far, compliance) : model_.wetLastBonded(compliance);
}

ContactState WettedContact::snappedIn(double approach, double compliance) const noexcept {
    const Jump jump = jumpAtEnd(compliance);
    ContactState state = landedAt(approach, compliance);
    state.jumped = jump.forceDrops;
    state.energyLost = std::max(0.0, jump.released);
    return state;
}

/// The bonded state at an approach where one must exist; rounding may put it on the fold.
ContactState WettedContact::landedAt(double approach, double compliance) const noexcept {
    const ContactState bonded = bondedAt(approach, compliance, kBondedMemory);
    return bonded.branch == ContactBranch::Bonded ? wetted(bonded)
                                                  : model_.wetLastBonded(compliance);
}

WettedContact::Jump WettedContact::jumpAtEnd(double compliance) const noexcept {
    const double end = endOfSeparate(compliance).approach;
    const auto before = separateAt(end, compliance);
    if (!before) {
        return {};
    }
    const ContactState landing = landedAt(end, compliance);
    return {.forceDrops = landing.force < before->force,
            .released = energy(*before, compliance) - energy(landing, compliance)};
}

/// Bodies that bond across a gap have the water's full pull at once, which may take more energy
/// than the jump releases: pull-off releases so much less.
ContactState WettedContact::pulledOff(ContactState state, double compliance) const noexcept {
    const ContactState fold = model_.wetLastBonded(compliance);
    const double end =
        std::min(model_.wetPullOffApproach(compliance), endOfSeparate(compliance).approach);
    if (const auto landing = separateAt(end, compliance)) {
        const double lent = std::min(0.0, jumpAtEnd(compliance).released);
        state.jumped = fold.force < landing->force;
        state.energyLost =
            std::max(0.0, energy(fold, compliance) - energy(*landing, compliance) + lent);
    }
    return state;
}

}  // namespace asperity
