#pragma once

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

}  // namespace asperity
