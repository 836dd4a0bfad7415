#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/probe/Cantilever.h"

namespace asperity {

/// Friction of tip on sample, T = mu N + tau A, never negative. Source: docs/theory.md 8.
struct Friction {
    double coefficient = 0.0;    ///< mu
    double shearStrength = 0.0;  ///< tau [Pa]

    bool operator==(const Friction&) const = default;
};

/// Tip, lever and sample material taken together: what decides the force at a given base position.
/// A scene has two of them: what is true (inside the simulated instrument) and what we believe.
struct ProbeSystem {
    ContactModel contact;
    Cantilever cantilever;
    Friction friction;
    bool curvature = true;  ///< whether the sample's curvature at the foot counts

    [[nodiscard]] double tipRadius() const noexcept { return contact.pair().tipRadius; }  ///< [m]
};

}  // namespace asperity
