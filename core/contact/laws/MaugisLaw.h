#pragma once

#include "core/contact/Material.h"
#include "core/contact/SolverSetting.h"
#include "core/contact/laws/LawPoint.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/contact/maugis/MaugisUnits.h"

#include <optional>

namespace asperity {

/// How the states of MaugisLaw along a way are found.
struct MaugisSolver {
    SolverSetting solver = SolverSetting::Exact;
    const MaugisTable* table = nullptr;  ///< must outlive the law; null: none covers it
};

/// Maugis-Dugdale in SI: a cohesive zone of constant stress around the contact, and without contact
/// across a gap. Exact from DMT to JKR; the surfaces attract each other within the range h0 = w /
/// sigma0. Valid for contact radii below about 0.3 R.
/// Source: Maugis (1992); Kim, McMeeking, Johnson (1998); docs/theory.md 2.3-2.7.
class MaugisLaw {
public:
    /// The pair's work of adhesion must be > 0. Beyond a transition parameter of 1e7, where the
    /// curve is JKR's to 1e-13, the stress is lowered.
    /// @param cohesiveStress sigma0 [Pa], > 0
    MaugisLaw(const ContactPair& pair, double cohesiveStress, MaugisSolver solver = {}) noexcept;

    [[nodiscard]] double lambda() const noexcept { return curve_.curve().lambda(); }
    [[nodiscard]] double cohesiveStress() const noexcept { return cohesiveStress_; }  ///< [Pa]
    /// h0 [m]
    [[nodiscard]] double range() const noexcept;

    // As LawPoint.h has it.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance) const noexcept;
    /// The same by the solver's setting. @param coordinate of a state near it, any number is
    /// allowed
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] double onset() const noexcept { return -range(); }

private:
    [[nodiscard]] MaugisControl control(double compliance) const noexcept;
    [[nodiscard]] LawPoint inSi(const MaugisPoint& point) const noexcept;
    [[nodiscard]] LawPoint inSi(const MaugisState& state) const noexcept;
    [[nodiscard]] double stiffnessInSi(double stiffness) const noexcept;

    MaugisUnits units_;
    double cohesiveStress_;
    MaugisDugdale curve_;
    MaugisSolver solver_;
};

}  // namespace asperity
