#pragma once

#include "core/contact/laws/ContactModel.h"

namespace asperity {

/// State of a contact with two works of adhesion, handed from one equilibrium to the next.
struct TwoWorkMemory {
    ContactBranch branch = ContactBranch::Far;
    double contactRadius = 0.0;  ///< while bonded [m]
};

/// JKR contact that costs more adhesion to open than it gains when it closes. The contact grows
/// while its energy release rate is below the work on approach and shrinks while that exceeds the
/// work on retract. In between the contact radius is held, and the force follows the slope
/// 2 a E* of a punch: it has no jump at a reversal, and small motions lose nothing.
/// With equal works this is the law itself. Real-time safe.
/// Source: Maugis, Barquins (1978); docs/theory.md 7.7.
class TwoWorkContact {
public:
    /// @param law Jkr or SphereJkr
    /// @param pair with the work of adhesion on approach
    /// @param retractWork work of adhesion on retract [J/m^2], at least that on approach
    /// @throw Error where the law, the pair or the works are outside their ranges
    TwoWorkContact(ContactLaw law, const ContactPair& pair, double retractWork);

    /// Equilibrium at `approach` = indentation + compliance x force [m] on a lever of this
    /// compliance [m/N], after the state in `memory`, which is replaced by the new one.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           TwoWorkMemory& memory) const noexcept;

    /// The law by which the contact grows, and that by which it shrinks.
    [[nodiscard]] const ContactModel& growing() const noexcept { return growing_; }
    [[nodiscard]] const ContactModel& shrinking() const noexcept { return shrinking_; }

private:
    [[nodiscard]] ContactState held(double approach, double compliance, const TwoWorkMemory& memory,
                                    double& release) const noexcept;

    ContactModel growing_;
    ContactModel shrinking_;
};

}  // namespace asperity
