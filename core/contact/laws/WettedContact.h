#pragma once

#include "core/contact/laws/ContactModel.h"

#include <optional>

namespace asperity {

/// A contact model's law with the pull of its meniscus. That is a constant while the bodies are
/// bonded and a straight line of the gap before, so that each equilibrium is one of the bare law on
/// a lever that is moved, or moved and softened. Units and errors as of ContactModel.
class WettedContact {
public:
    explicit WettedContact(const ContactModel& model) noexcept : model_(model) {}

    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           const ContactMemory& memory) const noexcept;
    /// Approach of the undeflected tip at which separate bodies lose their last stable state [m].
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept {
        return endOfSeparate(compliance).approach;
    }
    /// A state of the bare law with the meniscus' force on it.
    [[nodiscard]] ContactState wetted(ContactState state) const noexcept;

private:
    /// End of the branch of separate bodies.
    struct End {
        double approach = 0.0;      ///< of the undeflected tip [m]
        bool inWater = false;       ///< the bridge is there before that
        double softApproach = 0.0;  ///< the same on the lever that the bridge softens [m]
    };
    struct Jump {
        bool forceDrops = false;
        double released = 0.0;  ///< energy of bodies, meniscus and lever [J]
    };

    [[nodiscard]] End endOfSeparate(double compliance) const noexcept;
    [[nodiscard]] std::optional<ContactState> separateAt(double approach,
                                                         double compliance) const noexcept;
    [[nodiscard]] ContactState bondedAt(double approach, double compliance,
                                        const ContactMemory& memory) const noexcept;
    [[nodiscard]] ContactState landedAt(double approach, double compliance) const noexcept;
    [[nodiscard]] Jump jumpAtEnd(double compliance) const noexcept;
    [[nodiscard]] ContactState snappedIn(double approach, double compliance) const noexcept;
    [[nodiscard]] ContactState pulledOff(ContactState state, double compliance) const noexcept;
    [[nodiscard]] double energy(const ContactState& wetted, double compliance) const noexcept;

    const ContactModel& model_;
};

}  // namespace asperity
