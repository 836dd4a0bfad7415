#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/Cantilever.h"
#include "core/probe/Friction.h"
#include "core/probe/MaterialMaps.h"

#include <memory>

namespace asperity {

class HeightMoments;

/// Tip, lever and sample material taken together: what decides the force at a given base position.
/// A scene has two of them: what is true (inside the simulated instrument) and what we believe.
struct ProbeSystem {
    ContactModel contact;
    Cantilever cantilever;
    Friction friction;
    bool curvature = true;  ///< whether the sample's curvature at the closest point counts
    /// The sample that attracts the tip beside its contacts, see bodyForce(); null: none does.
    std::shared_ptr<const HeightMoments> beside = nullptr;
    /// What the sample is made of at each place, in place of the pair and the coefficient above,
    /// which stand for its stiffest and most adhesive parts; null: the same everywhere.
    std::shared_ptr<const MaterialField> field = nullptr;

    /// Whether the sample beside a contact attracts the tip: only a law with a van der Waals tail
    /// has attraction of a long range, and only one of the sample's curvature has an asperity.
    [[nodiscard]] bool attractsBeside() const noexcept {
        return beside != nullptr && hasTail(contact.law()) && takesCurvature();
    }
    /// Whether a contact has the effective radius of its place, not that of the tip.
    [[nodiscard]] bool takesCurvature() const noexcept {
        return curvature && !isSphere(contact.law());
    }
    [[nodiscard]] double tipRadius() const noexcept { return contact.pair().tipRadius; }  ///< [m]

    /// What the tip meets at a place of the surface under an effective radius [m].
    [[nodiscard]] ContactPair pairAt(const Vector3& place, double effectiveRadius) const noexcept;
    [[nodiscard]] Friction frictionAt(const Vector3& place) const noexcept;
};

}  // namespace asperity
