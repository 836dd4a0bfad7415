#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactModel.h"

namespace asperity {

/// Properties of sample and liquid that make the force of a contact depend on time: the sample
/// relaxes as a standard linear solid, E(t) = E_inf + E_1 exp(-t / tau), and a wall's drag slows
/// the tip, F_d = C v / (gap + h_off). Source: docs/theory.md 7.8.
struct TimeTerms {
    double relaxingShare = 0.0;   ///< E_1 over E_inf, which the contact law has; 0: elastic
    double relaxationTime = 1.0;  ///< tau [s]
    double drag = 0.0;            ///< C = 6 pi eta R^2 [N s]; 0: none
    double dragOffset = 1.0;      ///< h_off, gap that remains in contact [m]

    bool operator==(const TimeTerms&) const = default;

    [[nodiscard]] bool relaxes() const noexcept { return relaxingShare > 0.0; }
    [[nodiscard]] bool drags() const noexcept { return drag > 0.0; }
    [[nodiscard]] bool any() const noexcept { return relaxes() || drags(); }
};

/// Motion of a contact that its force depends on; carried from one equilibrium to the next.
struct TimeMemory {
    bool known = false;        ///< whether there was a state before
    double indentation = 0.0;  ///< < 0 is a gap [m]
    double load = 0.0;         ///< elastic force over the reduced modulus [m^2]
    double relaxing = 0.0;     ///< part of the load that has not relaxed [m^2]
};

/// One step in time of a contact under an elastic law that relaxes, or any law in a liquid, on a
/// lever. The relaxing part has one state, the load that it has not let go of: exact for a load
/// that is a straight line of time in the step, and for a contact that grows. While it shrinks,
/// it has less force than by Ting's theory; docs/theory.md 7.8 has how much. A surface that the tip
/// has left rises at its own pace. Passive: what a loop of motion returns is never more than it
/// took. Allocation-free, never throws.
class TimedContact {
public:
    TimedContact() = default;
    /// @param elapsed since the memory's state [s]; infinite: the sample has relaxed, nothing moves
    TimedContact(const TimeTerms& terms, const TimeMemory& memory, double elapsed) noexcept;

    /// Reduced modulus of the step over that of the relaxed sample: the law must have it.
    [[nodiscard]] double stiffening() const noexcept {
        return 1.0 + (terms_.relaxingShare * mean_);
    }

    /// The state at the end of the step, drag and relaxation in its force; as
    /// ContactModel::equilibrium().
    /// @param model with the reduced modulus of the step
    /// @param guess indentation for which the drag counts: that of the state, as far as known [m]
    [[nodiscard]] ContactState equilibrium(const ContactModel& model, double approach,
                                           double compliance, const ContactMemory& memory,
                                           double guess) const noexcept;

    /// What the next step starts from. @param state of equilibrium() with this model
    [[nodiscard]] TimeMemory after(const ContactModel& model,
                                   const ContactState& state) const noexcept;

private:
    [[nodiscard]] double relaxedForce(const ContactModel& model) const noexcept;

    TimeTerms terms_;
    TimeMemory memory_;
    double elapsed_ = 0.0;
    double decay_ = 0.0;  ///< exp(-elapsed / tau)
    double mean_ = 0.0;   ///< of the same over the step
};

}  // namespace asperity
