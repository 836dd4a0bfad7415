#pragma once

#include "core/EnumTable.h"
#include "core/contact/ContactStatus.h"

#include <cstdint>

namespace asperity {

/// Which stable state the tip is in; with adhesion the force is not a function of the gap alone.
enum class ContactBranch : std::uint8_t {
    Far,     ///< before snap-in: van der Waals attraction at most
    Bonded,  ///< after snap-in: contact, or a cohesive zone without contact
};

/// Where the tip is, for logs and people.
enum class TipRegion : std::uint8_t {
    Far,       ///< van der Waals attraction only
    Cohesive,  ///< bonded across a gap
    Contact,   ///< touching over a circle, or just in its middle
};

template <>
inline constexpr auto kEnumTable<TipRegion> = std::to_array<EnumRow<TipRegion>>(
    {{TipRegion::Far, "far"},
     {TipRegion::Cohesive, "cohesive", "cohesive (bonded across a gap)"},
     {TipRegion::Contact, "contact", "in contact"}});

/// What one equilibrium hands to the next.
struct ContactMemory {
    ContactBranch branch = ContactBranch::Far;
    double coordinate = 0.0;  ///< of the state on its law's curve; 0: none
};

/// Memory of a bonded tip whose coordinate on the curve of the law is not known.
inline constexpr ContactMemory kBondedMemory{ContactBranch::Bonded, 0.0};

/// One equilibrium of tip and sample along the surface normal.
struct ContactState {
    double force = 0.0;           ///< on the tip, along the outward normal, > 0 repulsive [N]
    double indentation = 0.0;     ///< approach of the undeformed bodies, < 0 is a gap [m]
    double contactRadius = 0.0;   ///< [m]
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone [m]
    double stiffness = 0.0;       ///< d(force)/d(indentation) [N/m]
    double energyLost = 0.0;      ///< dissipated by a jump that led into this state [J]
    double coordinate = 0.0;      ///< on the law's curve, for ContactMemory
    ContactBranch branch = ContactBranch::Far;
    bool jumped = false;  ///< the force jumped on the way to this state, between branches
    ContactStatus status = ContactStatus::Solved;  ///< else force and lengths are zero

    [[nodiscard]] bool solved() const noexcept { return status == ContactStatus::Solved; }
    [[nodiscard]] TipRegion region() const noexcept {
        if (branch == ContactBranch::Far) {
            return TipRegion::Far;
        }
        const bool acrossGap = cohesiveRadius > 0.0 && !(contactRadius > 0.0);
        return acrossGap ? TipRegion::Cohesive : TipRegion::Contact;
    }
    [[nodiscard]] ContactMemory memory() const noexcept { return {branch, coordinate}; }
};

}  // namespace asperity
