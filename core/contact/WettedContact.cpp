// The part of ContactModel that adds a meniscus to its law. The meniscus' pull is a constant while
// the bodies are bonded and a straight line of the gap before, so that each equilibrium is one of
// the bare law on a lever that is moved, or moved and softened.

#include "core/contact/ContactModel.h"

#include <algorithm>

namespace asperity {

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

/// Separate bodies at an approach; none where lever and meniscus are unstable or the law snaps in.
std::optional<ContactState> ContactModel::wettedFar(double approach,
                                                    double compliance) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const ContactState dry = bare(approach, compliance, {});
    if (dry.branch == ContactBranch::Far && dry.indentation <= -meniscus.range) {
        return dry;
    }
    const double moved = compliance * meniscus.pull(given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    if (stiff <= 0.0) {
        return std::nullopt;
    }
    const ContactState within = bare((approach + moved) / stiff, compliance / stiff, {});
    return within.branch == ContactBranch::Far ? std::optional(wetted(within)) : std::nullopt;
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
    return std::visit([&](const auto& joined) { return joined.bodyEnergy(dry); }, joined_) +
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
    const ContactMemory stuck{ContactBranch::Bonded, 0.0};
    ContactState state = wetted(wettedBonded(approach, compliance, stuck));
    const double end = wettedJumpIn(compliance);
    if (const auto before = wettedFar(end, compliance)) {
        const ContactState landing = wetted(wettedBonded(end, compliance, stuck));
        state.jumped = landing.force < before->force;
        state.energyLost = std::max(0.0, energy(*before, compliance) - energy(landing, compliance));
    }
    return state;
}

ContactState ContactModel::wettedPullOff(ContactState state, double compliance) const noexcept {
    const ContactState fold = lastBonded(compliance);
    if (const auto landing = wettedFar(pullOffApproach(compliance), compliance)) {
        state.jumped = fold.force < landing->force;
        state.energyLost = std::max(0.0, energy(fold, compliance) - energy(*landing, compliance));
    }
    return state;
}

double ContactModel::wettedJumpIn(double compliance) const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    const auto jumpIn = [this](double soft) {
        return std::visit([&](const auto& joined) { return joined.jumpInApproach(soft); }, joined_);
    };
    const double dry = jumpIn(compliance);
    if (bare(dry, compliance, {}).indentation <= -meniscus.range) {
        return dry;
    }
    const double moved = compliance * meniscus.pull(given_.pair.tipRadius);
    const double stiff = 1.0 - (moved / meniscus.range);
    if (stiff <= 0.0) {
        return -meniscus.range;
    }
    return (stiff * jumpIn(compliance / stiff)) - moved;
}

}  // namespace asperity
