#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/Cantilever.h"
#include "core/probe/Friction.h"
#include "core/probe/MaterialMaps.h"

#include <memory>

namespace asperity {

/// Tip, lever and sample material taken together: what decides the force at a given base position.
/// A scene has two of them: what is true (inside the simulated instrument) and what we believe.
struct ProbeSystem {
    ContactModel contact;
    Cantilever cantilever;
    Friction friction;
    bool curvature = true;  ///< whether the sample's curvature at the closest point counts
    /// What the sample is made of at each place, in place of the pair and the coefficient above,
    /// which stand for its stiffest and most adhesive parts; null: the same everywhere.
    std::shared_ptr<const MaterialField> field = nullptr;

    [[nodiscard]] double tipRadius() const noexcept { return contact.pair().tipRadius; }  ///< [m]

    /// What the tip meets at a place of the surface under an effective radius [m].
    [[nodiscard]] ContactPair pairAt(const Vector3& place, double effectiveRadius) const noexcept;
    [[nodiscard]] Friction frictionAt(const Vector3& place) const noexcept;
};

}  // namespace asperity
