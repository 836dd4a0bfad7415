#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/ConeMaugisLaw.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTable.h"

#include <optional>
#include <utility>

namespace asperity {

/// Method that finds the states of MaugisLaw along a path.
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

    // As ContactLaw.h has it.
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

/// Division of the work of adhesion between the van der Waals tail and the cohesive zone.
/// Source: docs/theory.md 3.4.
struct AdhesionSplit {
    double hamaker = 0.0;          ///< Hamaker constant of the tail [J]
    double jointSeparation = 0.0;  ///< D_s: the tail acts beyond it, the cohesive zone within [m]
    double cohesiveWork = 0.0;     ///< work of adhesion of the cohesive zone [J/m^2]
    double cohesiveStress = 0.0;   ///< sigma0 [Pa]
    double tailForce = 0.0;        ///< of the tail while bonded, <= 0 [N]
    double tailLift = 0.0;         ///< of the surface by the tail while bonded, >= 0 [m]
    double tailEnergy = 0.0;       ///< of the tail at the joint, <= 0 [J]
    bool tailSnaps = false;        ///< the tail is unstable at the joint: the zone has all of w
};

/// The tail of a pair with work of adhesion > 0, down to where the cohesive zone takes over.
[[nodiscard]] AttractiveTail splitTail(const ContactPair& pair) noexcept;

/// Returns the shares of a pair's tail and zone. @param tail splitTail() of the pair
[[nodiscard]] AdhesionSplit adhesionSplit(const ContactPair& pair,
                                          const AttractiveTail& tail) noexcept;

/// The bonded side of a split van der Waals and Maugis-Dugdale model: the cohesive zone acts, and
/// what the tail does outside of it is a constant force and lift. Before it acts splitTail(). Force
/// and indentation are continuous where a tail that does not snap ends at the joint, since every
/// zone begins there with no force across its whole range.
/// Source: docs/theory.md 3.4, equation (3.3).
/// @tparam Zone a class as ContactLaw.h describes, with a cohesive zone
template <class Zone>
class TailedLaw {
public:
    /// @param zone has the work and the stress of the split
    TailedLaw(const AdhesionSplit& split, Zone zone) noexcept
        : split_(split), zone_(std::move(zone)) {
        split_.cohesiveStress = zone_.cohesiveStress();  // the zone may lower it, see MaugisLaw
    }

    [[nodiscard]] const AdhesionSplit& split() const noexcept { return split_; }
    [[nodiscard]] double cohesiveStress() const noexcept { return split_.cohesiveStress; }
    /// Transition parameter of the cohesive zone.
    [[nodiscard]] double lambda() const noexcept { return zone_.lambda(); }

    // As ContactLaw.h has it; the energy is counted from infinite separation.
    [[nodiscard]] LawPoint fold(double compliance) const noexcept {
        return withTail(zone_.fold(compliance));
    }
    [[nodiscard]] std::optional<LawPoint> stable(double approach,
                                                 double compliance) const noexcept {
        return withTail(zone_.stable(approachOfZone(approach, compliance), compliance));
    }
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate) const noexcept requires
        requires(const Zone& zone) {
        zone.stable(0.0, 0.0, 0.0);
    }
    { return withTail(zone_.stable(approachOfZone(approach, compliance), compliance, coordinate)); }
    [[nodiscard]] double energy(LawPoint point) const noexcept {
        point.force -= split_.tailForce;
        point.indentation += split_.tailLift;
        const double moved = point.indentation - zone_.onset();
        return split_.tailEnergy + (split_.tailForce * moved) + zone_.energy(point);
    }

private:
    [[nodiscard]] double approachOfZone(double approach, double compliance) const noexcept {
        return approach + split_.tailLift - (compliance * split_.tailForce);
    }
    [[nodiscard]] LawPoint withTail(LawPoint point) const noexcept {
        point.force += split_.tailForce;
        point.indentation -= split_.tailLift;
        return point;
    }
    [[nodiscard]] std::optional<LawPoint>
    withTail(const std::optional<LawPoint>& point) const noexcept {
        return point ? std::optional(withTail(*point)) : std::nullopt;
    }

    AdhesionSplit split_;
    Zone zone_;
};

using SplitLaw = TailedLaw<MaugisLaw>;
using SphereSplitLaw = TailedLaw<SphereMaugisLaw>;
using ConeSplitLaw = TailedLaw<ConeMaugisLaw>;

/// The pair's work of adhesion must be > 0. @param tail splitTail() of the pair
[[nodiscard]] SplitLaw splitLaw(const ContactPair& pair, const AttractiveTail& tail,
                                MaugisSolver solver = {}) noexcept;

/// The same under the exact sphere.
[[nodiscard]] SphereSplitLaw sphereSplitLaw(const ContactPair& pair,
                                            const AttractiveTail& tail) noexcept;

/// The same under a sphere that goes on as a cone; the tail is the sphere's alone.
[[nodiscard]] ConeSplitLaw coneSplitLaw(const ContactPair& pair, const AttractiveTail& tail,
                                        double coneHalfAngle) noexcept;

}  // namespace asperity
