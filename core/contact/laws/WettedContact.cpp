// The part of ContactModel that adds a meniscus to its law. The meniscus' pull is a constant while
// the bodies are bonded and a straight line of the gap before, so that each equilibrium is one of
// the bare law on a lever that is moved, or moved and softened.

#include "core/contact/laws/JoinedLaws.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr ContactMemory kBonded{ContactBranch::Bonded, 0.0};

}  // namespace

/// A state of the bare law with the meniscus' force on it.
ContactState ContactModel::wetted(ContactState state) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const double radius = given_.pair.tipRadius;
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
ContactModel::WettedEnd ContactModel::wettedEnd(double compliance) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const auto jumpIn = [this](double soft) {
        return onJoined([&](const auto& joined) { return joined.jumpInApproach(soft); });
    };
    const double dry = jumpIn(compliance);
    if (bare(dry, compliance, {}).indentation <= -meniscus.range) {
        return {.approach = dry};
    }
    const double moved = compliance * meniscus.pull(given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    if (stiff > 0.0) {
        const double end = jumpIn(compliance / stiff);
        if (bare(end, compliance / stiff, {}).indentation > -meniscus.range) {
            return {.approach = (stiff * end) - moved, .inWater = true, .softApproach = end};
        }
    }
    return {.approach = (compliance * bare(-meniscus.range, 0.0, {}).force) - meniscus.range};
}

/// Separate bodies at an approach; none beyond the end of their branch.
std::optional<ContactState> ContactModel::wettedFar(double approach,
                                                    double compliance) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const WettedEnd end = wettedEnd(compliance);
    if (approach > end.approach) {
        return std::nullopt;
    }
    const ContactState dry = bare(approach, compliance, {});
    const bool apart = dry.branch == ContactBranch::Far && dry.indentation <= -meniscus.range;
    if (apart || !end.inWater) {
        return dry;
    }
    const double moved = compliance * meniscus.pull(given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    const double held = std::min((approach + moved) / stiff, end.softApproach);
    return wetted(bare(held, compliance / stiff, {}));
}

ContactState ContactModel::wettedBonded(double approach, double compliance,
                                        const ContactMemory& memory) const noexcept {
    const double moved = compliance * given_.options.meniscus.pull(given_.pair.tipRadius);
    return bare(approach + moved, compliance, memory);
}

/// Of bodies, meniscus and lever [J].
double ContactModel::energy(const ContactState& wetted, double compliance) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const double radius = given_.pair.tipRadius;
    const bool bonded = wetted.branch == ContactBranch::Bonded;
    ContactState dry = wetted;
    dry.force -= bonded ? -meniscus.pull(radius) : meniscus.force(radius, wetted.indentation);
    return onJoined([&](const auto& joined) { return joined.bodyEnergy(dry); }) +
           meniscus.energy(radius, wetted.indentation, bonded) +
           leverEnergy(wetted.force, compliance);
}

ContactState ContactModel::wettedEquilibrium(double approach, double compliance,
                                             const ContactMemory& memory) const noexcept {
    const auto far = wettedFar(approach, compliance);
    if (memory.branch == ContactBranch::Far) {
        return far ? *far : wettedSnapIn(approach, compliance);
    }
    const ContactState bonded = wettedBonded(approach, compliance, memory);
    if (bonded.branch == ContactBranch::Bonded) {
        return wetted(bonded);
    }
    // Where rounding leaves neither branch, the two meet.
    return far ? wettedPullOff(*far, compliance) : lastBonded(compliance);
}

ContactState ContactModel::wettedSnapIn(double approach, double compliance) const noexcept {
    const WettedJump jump = wettedJump(compliance);
    ContactState state = wettedLanding(approach, compliance);
    state.jumped = jump.forceDrops;
    state.energyLost = std::max(0.0, jump.released);
    return state;
}

/// The bonded state at an approach where one must exist; rounding may put it on the fold.
ContactState ContactModel::wettedLanding(double approach, double compliance) const noexcept {
    const ContactState bonded = wettedBonded(approach, compliance, kBonded);
    return bonded.branch == ContactBranch::Bonded ? wetted(bonded) : lastBonded(compliance);
}

ContactModel::WettedJump ContactModel::wettedJump(double compliance) const noexcept {
    const double end = wettedEnd(compliance).approach;
    const auto before = wettedFar(end, compliance);
    if (!before) {
        return {};
    }
    const ContactState landing = wettedLanding(end, compliance);
    return {.forceDrops = landing.force < before->force,
            .released = energy(*before, compliance) - energy(landing, compliance)};
}

/// Bodies that bond across a gap have the water's full pull at once, which may take more energy
/// than the jump releases: pull-off releases so much less.
ContactState ContactModel::wettedPullOff(ContactState state, double compliance) const noexcept {
    const ContactState fold = lastBonded(compliance);
    const double end = std::min(pullOffApproach(compliance), wettedEnd(compliance).approach);
    if (const auto landing = wettedFar(end, compliance)) {
        const double lent = std::min(0.0, wettedJump(compliance).released);
        state.jumped = fold.force < landing->force;
        state.energyLost =
            std::max(0.0, energy(fold, compliance) - energy(*landing, compliance) + lent);
    }
    return state;
}

}  // namespace asperity
