#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// A water bridge between tip and sample: F = -4 pi R gamma cos(theta) (1 - D/d) at gaps D below d,
/// its full pull while they are bonded. From the literature, not derived or verified here.
/// Source: Israelachvili, as quoted in docs/theory.md 3.5.
struct Meniscus {
    double surfaceTension = 0.0;  ///< gamma [N/m]; 0: no meniscus
    double contactAngle = 0.0;    ///< theta [rad]
    double range = 0.0;           ///< d = 2 r_K cos(theta) [m]

    bool operator==(const Meniscus&) const = default;

    [[nodiscard]] bool present() const noexcept { return surfaceTension > 0.0 && range > 0.0; }
    /// Largest pull [N], >= 0. @param tipRadius R [m]
    [[nodiscard]] double pull(double tipRadius) const noexcept;
    /// Force at an indentation of separate bodies, <= 0 [N].
    [[nodiscard]] double force(double tipRadius, double indentation) const noexcept;
    /// Work done on the bodies from infinite separation [J]. @param bonded the full pull acts
    [[nodiscard]] double energy(double tipRadius, double indentation, bool bonded) const noexcept;
};

/// Method that finds a Maugis-Dugdale state: a choice of speed only, within the error bound that
/// the table states. Folds are exact in every setting.
enum class SolverSetting : std::uint8_t {
    Exact,   ///< afresh each time
    Newton,  ///< by Newton's method from the previous state
    Table,   ///< from a table over transition parameter and indentation
};

template <>
inline constexpr auto kEnumTable<SolverSetting> =
    std::to_array<EnumRow<SolverSetting>>({{SolverSetting::Exact, "exact"},
                                           {SolverSetting::Newton, "newton"},
                                           {SolverSetting::Table, "table"}});

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

/// Options of a contact besides a law and a pair of materials.
struct ContactOptions {
    double cohesiveStress = 0.0;  ///< sigma0 of the Maugis laws [Pa]; 0: w / kCohesiveRange
    double filmThickness = 0.0;   ///< of the sample [m]; 0: a half-space
    FilmElasticity film;          ///< of that film; by default incompressible, under a rigid tip
    /// Half angle of the cone that touches the tip's sphere all around, 0.01 .. 1.55 [rad]; 0: a
    /// sphere up to its equator. Laws of a paraboloid use neither, see leavesOutCone().
    double coneHalfAngle = 0.0;
    /// Work of adhesion while the contact shrinks over that while it grows, >= 1; of laws of JKR
    /// alone, see TwoWorkContact.h.
    double adhesionRatio = 1.0;
    Meniscus meniscus;  ///< by default none
    SolverSetting solver = SolverSetting::Newton;
};

}  // namespace asperity
