#pragma once

#include "core/Vector.h"
#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/TimedContact.h"
#include "core/surface/closest/ClosestPointTracker.h"

#include <array>
#include <cstddef>
#include <limits>

namespace asperity {

class SampleSurface;
struct ProbeSystem;

/// Position and motion of the cantilever's base. The position is that of the tip's apex with
/// the lever undeflected; lab frame.
struct BaseMotion {
    Vector3 position = Vector3::Zero();  ///< [m]
    Vector3 velocity = Vector3::Zero();  ///< [m/s]
    /// Since the state of before [s]; infinite: as long as everything takes to come to rest.
    double elapsed = std::numeric_limits<double>::infinity();
};

/// Memory of one closest point of the tip.
struct ClosestPointMemory {
    SearchGuess guess;
    ContactMemory contact;
    TimeMemory time;
    double friction = 0.0;  ///< tangential force [N]
};

/// State carried from one equilibrium to the next on the same surface: warm starts and adhesion
/// branches.
struct EquilibriumMemory {
    std::array<ClosestPointMemory, kMaxContactPoints> points{};
    std::size_t pointCount = 0;            ///< 0: nothing is known yet
    Vector3 deflection = Vector3::Zero();  ///< of the tip, lab frame [m]
    Vector3 tip = Vector3::Zero();         ///< apex, where the points were left, lab frame [m]
    bool mayLackPoint = false;             ///< as TipState::mayLackPoint
};

/// The tip in quasi-static equilibrium between lever and sample; lab frame. In a valley that the
/// tip does not fit `force` is the sum over its closest points; the rest describes the main one.
struct TipState {
    Vector3 tip = Vector3::Zero();      ///< apex [m]
    Vector3 force = Vector3::Zero();    ///< of the sample on the tip [N]
    Vector3 slip = Vector3::Zero();     ///< direction of the friction force on the tip, length <= 1
    Vector3 normal = Vector3::UnitZ();  ///< direction of the sum of normal forces, unit, outward
    double normalForce = 0.0;           ///< that sum along `normal`, > 0 repulsive [N]
    ClosestPoint closest;               ///< of the center of the tip's sphere
    ContactState contact;               ///< along closest.normal
    BodyPull body;  ///< part of contact.force: attraction by the sample beside the contact
    double contactArea = 0.0;   ///< of all closest points [m^2]
    double contactRatio = 0.0;  ///< largest contact radius over effective radius of a closest point
    double effectiveRadius = 0.0;  ///< of tip and curved sample together [m]
    int points = 1;                ///< that bear a force
    double interaction = 0.0;  ///< largest share of its indentation by which a contact sinks under
                               ///< what the others press, N / (pi E* d) at a distance d
    bool overlapping = false;  ///< two contact circles overlap: the sum counts matter twice
    SearchProof proof = SearchProof::NotSought;  ///< whether all closest points are known
    /// The search left it open whether there are other closest points, or one before did, and a
    /// contact that it missed may hold the tip still: contacts remember how they came about until
    /// the lever tears them off.
    bool mayLackPoint = false;
    bool tipFits = true;       ///< false: valley narrower than the tip
    bool anisotropic = false;  ///< effectiveRadius is approximate
    bool converged = false;    ///< tip position found to rounding
    bool locked = false;       ///< friction would lock the lever: no quasi-static state
};

/// Solves tip = base + C F(tip) for the position of the tip, C the lever's compliance, F the sum
/// over all closest points, each with the effective radius of its position: those that the tip
/// presses on, that hold it or that attract it, see ContactModel::attractionRange(), the nearest
/// kMaxContactPoints of them. Where there are more, the proof is TooManyPoints. If the system has
/// the attraction of the sample beside a contact, the main one has it of a height field, less what
/// the laws of all contacts count. A base beyond 500 m along an axis or at no number has the
/// contact status ApproachOutOfRange, does not converge and leaves the memory as it is.
/// Allocation-free, bounded, never throws.
/// @param tracker of this surface: saves time, changes nothing
/// Source: docs/theory.md 1, 3.8, 7.1-7.2.
[[nodiscard]] TipState tipEquilibrium(const SampleSurface& surface, const ProbeSystem& system,
                                      const BaseMotion& base, EquilibriumMemory& memory,
                                      ClosestPointTracker& tracker) noexcept;
[[nodiscard]] TipState tipEquilibrium(const SampleSurface& surface, const ProbeSystem& system,
                                      const BaseMotion& base, EquilibriumMemory& memory) noexcept;

/// State of a tip that is held at `tip` (apex) whatever the lever, i.e. in displacement control;
/// `memory` stays as it is.
[[nodiscard]] TipState heldTip(const SampleSurface& surface, const ProbeSystem& system,
                               const BaseMotion& tip, const EquilibriumMemory& memory,
                               ClosestPointTracker& tracker) noexcept;
[[nodiscard]] TipState heldTip(const SampleSurface& surface, const ProbeSystem& system,
                               const BaseMotion& tip, const EquilibriumMemory& memory) noexcept;

}  // namespace asperity
