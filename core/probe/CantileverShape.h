#pragma once

#include "core/Vector.h"
#include "core/probe/Cantilever.h"

namespace asperity {

/// The bent beam's axis at one distance from the clamp, cantilever frame.
struct CantileverShape {
    double deflection = 0.0;         ///< along z of the cantilever [m]
    double slope = 0.0;              ///< of the deflection [rad]
    double lateralDeflection = 0.0;  ///< along y of the cantilever [m]
    double lateralSlope = 0.0;       ///< of the lateral deflection, which no signal shows [rad]
    double torsion = 0.0;            ///< turn about the beam's axis [rad]
};

/// Shape under a force on the tip (lab frame [N]) at `distance` from the clamp, 0 .. length [m].
/// From the tip on the beam is straight.
/// Source: docs/theory.md 5.3.
[[nodiscard]] CantileverShape cantileverShape(const Cantilever& cantilever, const Vector3& force,
                                              double distance) noexcept;

}  // namespace asperity
