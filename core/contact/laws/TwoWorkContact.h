#pragma once

#include "core/contact/laws/ContactModel.h"

#include <limits>

namespace asperity {

/// Memory of a bonded contact that has only grown so far.
inline constexpr ContactMemory kGrowingMemory{.branch = ContactBranch::Bonded,
                                              .coordinate = 0.0,
                                              .contactRadius = std::numeric_limits<double>::min()};

/// JKR contact that costs more adhesion to open than it gains when it closes. The contact grows
/// while its energy release rate is below the work on approach and shrinks while that exceeds the
/// work on retract. In between the contact radius is held, and the force follows the slope
/// 2 a E* of a punch: it has no jump at a reversal, and small motions lose nothing.
/// With equal works this is the law itself. Real-time safe.
/// Source: Maugis, Barquins (1978); docs/theory.md 7.7.
class TwoWorkContact {
public:
    /// @param model whose work of adhesion is that on approach, see ContactModel::adhesionRatio()
    explicit TwoWorkContact(const ContactModel& model) noexcept
        : growing_(model.growing()), shrinking_(model.shrinking()) {}

    /// As ContactModel::equilibrium(). The radius in `memory` is held.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           const ContactMemory& memory) const noexcept;

private:
    [[nodiscard]] ContactState held(double approach, double compliance, double radius,
                                    double& release) const noexcept;

    ContactModel growing_;
    ContactModel shrinking_;
};

}  // namespace asperity
