#pragma once

#include "core/contact/ContactState.h"
#include "core/probe/BodySum.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"

#include <algorithm>
#include <optional>
#include <span>

namespace asperity {

/// One closest point of a tip with the contact law of its position and the force it bears.
struct TipContactPoint {
    ClosestPoint foot;  ///< closest point of the surface
    ClosestPointMemory memory;
    TimedContact timed;
    ContactModel model;
    Friction friction;
    EffectiveRadius radius;
    ContactState contact;
    Vector3 slip = Vector3::Zero();
    Vector3 force = Vector3::Zero();    ///< on the tip, lab frame [N]
    Vector3 foundAt = Vector3::Zero();  ///< deflection of the lever that it was found at [m]
    double jumpLoss = 0.0;              ///< energy lost by a jump that stays, see keepJump() [J]
    bool jumpStays = false;

    /// Takes effective radius and material of its position; whether one of them changed.
    bool followSample(const ProbeSystem& system) noexcept;
    /// Sets slip, contact and force of a tip held where `foot` was found from.
    /// @param velocity of the base [m/s]
    void hold(double tipRadius, const Vector3& velocity) noexcept;

    /// Makes the contact's branch, where it has changed, that from which the search goes on.
    void keepJump() noexcept;
    /// Marks the contact as jumped where the search went on after a jump.
    void tellJump() noexcept;

    [[nodiscard]] double stiffness() const noexcept { return std::max(0.0, contact.stiffness); }
    /// On a tip at another deflection, to first order [N].
    [[nodiscard]] Vector3 forceAt(const Vector3& deflection) const noexcept {
        return force - stiffness() * foot.normal.dot(deflection - foundAt) * foot.normal;
    }
    [[nodiscard]] double area() const noexcept;           ///< of contact [m^2]
    [[nodiscard]] double frictionForce() const noexcept;  ///< of a sliding tip [N]
    /// Radius of the contact circle, with its cohesive zone [m].
    [[nodiscard]] double reach() const noexcept {
        return std::max(contact.contactRadius, contact.cohesiveRadius);
    }
    /// Depth of the contact [m]: by indentation, or by the width that adhesion gives it.
    [[nodiscard]] double depth() const noexcept {
        return std::max(contact.indentation,
                        contact.contactRadius * contact.contactRadius / radius.radius);
    }
};

/// Attraction of a tip by the sample beside its contacts while its equilibrium is sought: summed
/// where the tip is, and from there on a straight line, see BodyForce. Nothing where the sample
/// does not attract. Source: docs/theory.md 3.8.
class BesideContacts {
public:
    explicit BesideContacts(const ProbeSystem& system) noexcept
        : system_(system), attracts_(system.attractsBeside()) {}

    [[nodiscard]] bool attracts() const noexcept { return attracts_; }

    /// Sums for contact points, the main one first, and an apex [m].
    void sum(std::span<const TipContactPoint> points, const Vector3& tip) noexcept;
    /// Sums again where the last sum is off at another position; whether it did.
    bool follow(std::span<const TipContactPoint> points, const Vector3& tip) noexcept;
    /// Makes the next follow() sum: the last sum was for other points.
    void forget() noexcept { error_ = 0.0; }

    /// Estimates where a tip that begins here will end: as long as a contact holds it, its
    /// indentation changes little. @param before apex where the main point was left [m]
    [[nodiscard]] Vector3 likelyTip(const TipContactPoint& main, const Vector3& tip,
                                    const Vector3& before) const noexcept;

    /// Gives the main point the attraction at a position of the apex.
    /// @param compliance of the lever along the normal [m/N]
    void pull(std::span<TipContactPoint> points, const Vector3& tip, double compliance) noexcept;

private:
    const ProbeSystem& system_;
    bool attracts_;
    std::optional<BodyForce> force_;
    double error_ = 0.0;  ///< that its gradient may have [N]
};

}  // namespace asperity
