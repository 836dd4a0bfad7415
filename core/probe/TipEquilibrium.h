#pragma once

#include "core/Vector.h"
#include "core/probe/ProbeSystem.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/ClosestPoint.h"

namespace asperity {

/// Where the cantilever's base is and how it moves. The base position is given as the place that
/// the tip's apex takes when the lever is not deflected; lab frame.
struct BaseMotion {
    Vector3 position = Vector3::Zero();  ///< [m]
    Vector3 velocity = Vector3::Zero();  ///< [m/s]
};

/// What one equilibrium hands to the next: warm starts and the adhesion branch.
struct EquilibriumMemory {
    FootGuess foot;
    ContactBranch branch = ContactBranch::Far;
    Vector3 deflection = Vector3::Zero();  ///< of the tip, lab frame [m]
    double friction = 0.0;                 ///< tangential force [N]
};

/// The tip in quasi-static equilibrium between lever and sample; lab frame.
struct TipState {
    Vector3 tip = Vector3::Zero();    ///< apex [m]
    Vector3 force = Vector3::Zero();  ///< of the sample on the tip [N]
    Vector3 slip = Vector3::Zero();   ///< direction of the friction force on the tip, length <= 1
    SurfaceFoot foot;                 ///< of the centre of the tip's sphere
    ContactState contact;             ///< along foot.normal
    bool converged = false;           ///< tip position found to rounding
    bool locked = false;              ///< friction would lock the lever: no quasi-static state
};

/// Solves tip = base + C F(tip) for the position of the tip, C the lever's compliance.
/// Allocation-free, bounded, never throws. Source: docs/physics.md 7.1-7.2.
[[nodiscard]] TipState tipEquilibrium(const BSplineSurface& surface, const ProbeSystem& system,
                                      const BaseMotion& base, EquilibriumMemory& memory) noexcept;

}  // namespace asperity
