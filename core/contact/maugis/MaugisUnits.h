#pragma once

#include "core/contact/Material.h"

namespace asperity {

/// Units of the dimensionless Maugis-Dugdale curve for one material pair and cohesive stress.
/// Source: docs/theory.md 1.
struct MaugisUnits {
    double radius = 0.0;       ///< of contact and cohesive radius [m]
    double force = 0.0;        ///< pi w R [N]
    double indentation = 0.0;  ///< [m]

    [[nodiscard]] double energy() const noexcept { return force * indentation; }  ///< [J]
};

[[nodiscard]] MaugisUnits maugisUnits(const ContactPair& pair) noexcept;

/// Transition parameter lambda: near 0 for stiff, small tips (DMT), large for soft, large ones
/// (JKR).
/// @param cohesiveStress sigma0 [Pa]
[[nodiscard]] double transitionParameter(const MaugisUnits& units, double cohesiveStress) noexcept;

}  // namespace asperity
