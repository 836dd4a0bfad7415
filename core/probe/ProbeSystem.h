#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/probe/Cantilever.h"
#include "core/probe/Friction.h"

namespace asperity {

/// Tip, lever and sample material taken together: what decides the force at a given base position.
/// A scene has two of them: what is true (inside the simulated instrument) and what we believe.
struct ProbeSystem {
    ContactModel contact;
    Cantilever cantilever;
    Friction friction;
    bool curvature = true;  ///< whether the sample's curvature at the closest point counts

    [[nodiscard]] double tipRadius() const noexcept { return contact.pair().tipRadius; }  ///< [m]
};

}  // namespace asperity
