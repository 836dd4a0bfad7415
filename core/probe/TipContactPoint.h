#pragma once

#include "core/contact/EffectiveRadius.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipEquilibrium.h"

#include <algorithm>

namespace asperity {

/// One closest point of a tip with the contact law of its place and the force it bears.
struct TipContactPoint {
    ClosestPoint place;
    ClosestPointMemory memory;
    ContactModel model;
    Friction friction;
    EffectiveRadius radius;
    ContactState contact;
    Vector3 slip = Vector3::Zero();
    Vector3 force = Vector3::Zero();    ///< on the tip, lab frame [N]
    Vector3 foundAt = Vector3::Zero();  ///< deflection of the lever that it was found at [m]
    double jumpLoss = 0.0;              ///< energy lost by a jump that stays, see keepJump() [J]
    bool jumpStays = false;

    /// Takes effective radius and material of its place; whether one of them changed.
    bool followSample(const ProbeSystem& system) noexcept;
    /// Bears what a tip does that is held where the place was found from.
    /// @param velocity of the base [m/s]
    void hold(double tipRadius, const Vector3& velocity) noexcept;

    /// Where the contact has changed its branch, makes this one that from which the search goes on.
    void keepJump() noexcept;
    /// Says of the contact that it jumped, where the search went on after that.
    void tellJump() noexcept;

    [[nodiscard]] double stiffness() const noexcept { return std::max(0.0, contact.stiffness); }
    /// On a tip at another deflection, to first order [N].
    [[nodiscard]] Vector3 forceAt(const Vector3& deflection) const noexcept {
        return force - stiffness() * place.normal.dot(deflection - foundAt) * place.normal;
    }
    [[nodiscard]] double area() const noexcept;           ///< of contact [m^2]
    [[nodiscard]] double frictionForce() const noexcept;  ///< of a sliding tip [N]
    /// Radius of the contact circle, with its cohesive zone [m].
    [[nodiscard]] double reach() const noexcept {
        return std::max(contact.contactRadius, contact.cohesiveRadius);
    }
    /// How deep the contact is [m]: by indentation, or by the width that adhesion gives it.
    [[nodiscard]] double depth() const noexcept {
        return std::max(contact.indentation,
                        contact.contactRadius * contact.contactRadius / radius.radius);
    }
};

}  // namespace asperity
