#pragma once

#include "core/contact/SolverSetting.h"
#include "core/contact/laws/Meniscus.h"

namespace asperity {

/// Range of the cohesive stress that is taken where a scene names none, h0 = D0 (sqrt(10) - 1) [m].
/// Source: docs/theory.md 1, 3.4.
inline constexpr double kCohesiveRange = 0.35677581392778259e-9;

/// Elasticity of a film on a rigid base under a tip.
struct FilmElasticity {
    double poissonRatio = 0.5;  ///< of the film, 0 .. 0.5
    /// The film's part of the compliance 1 / E* that both bodies would have as half-spaces, 0 .. 1;
    /// the tip, an elastic half-space, has the rest. 1: a rigid tip.
    double share = 1.0;

    bool operator==(const FilmElasticity&) const = default;
};

/// What a contact may have besides a law and a pair of materials.
struct ContactOptions {
    double cohesiveStress = 0.0;  ///< sigma0 of the Maugis laws [Pa]; 0: w / kCohesiveRange
    double filmThickness = 0.0;   ///< of the sample [m]; 0: a half-space
    FilmElasticity film;          ///< of that film; by default incompressible, under a rigid tip
    /// Half angle of the cone that touches the tip's sphere all around, 0.01 .. 1.55 [rad]; 0: a
    /// sphere up to its equator. Laws of a paraboloid use neither, see leavesOutCone().
    double coneHalfAngle = 0.0;
    Meniscus meniscus;  ///< by default none
    SolverSetting solver = SolverSetting::Newton;
};

}  // namespace asperity
