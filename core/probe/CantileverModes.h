#pragma once

#include "core/probe/Cantilever.h"

namespace asperity {

/// One flexural mode of a clamped-free beam, normalized to the deflection of its free end.
struct FlexuralMode {
    double waveNumber = 0.0;        ///< beta_n l, a root of cos x cosh x = -1
    double angularFrequency = 0.0;  ///< omega_n [rad/s]
    double stiffness = 0.0;         ///< k_n [N/m]
    double mass = 0.0;              ///< k_n / omega_n^2 [kg]
    double endSlope = 0.0;          ///< slope of the free end per its deflection [rad/m]

    [[nodiscard]] double frequency() const noexcept;  ///< f_n [Hz]
};

/// Flexural mode `number`, 1: the fundamental. Source: docs/theory.md 7.3, T17; the slope from the
/// mode shape cosh - cos - sigma (sinh - sin).
/// @throw Error when the number is not 1 to 100 or the geometry is no beam
[[nodiscard]] FlexuralMode flexuralMode(const CantileverGeometry& geometry, int number);

/// Mass of the beam without its tip [kg].
[[nodiscard]] double beamMass(const CantileverGeometry& geometry) noexcept;

/// Thickness [m] that gives a beam of known modulus its fundamental resonance [Hz].
[[nodiscard]] double thicknessForResonance(const CantileverGeometry& geometry, double resonance);

/// The beam whose thickness and Young's modulus give both the stiffness at the tip [N/m] and the
/// fundamental resonance [Hz] that were measured on it; length, width and density are kept.
[[nodiscard]] CantileverGeometry withStiffnessAndResonance(CantileverGeometry geometry,
                                                           double stiffness, double resonance);

}  // namespace asperity
