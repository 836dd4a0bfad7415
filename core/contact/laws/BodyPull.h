#pragma once

#include <limits>

namespace asperity {

/// A force on the tip beside that of the contact law, as a straight line of the indentation: the
/// attraction by the sample around the contact, see BodyAttraction.h.
///
/// On a lever it is what a meniscus is: each equilibrium is one of the bare law on a lever that is
/// moved, and softened or stiffened. With a(d) = d + c F(d) the law's approach at an indentation d,
/// F + p + g d in place of F is a law's approach (a - c p) / (1 + c g) on a lever of compliance
/// c / (1 + c g), and energies at a given approach differ by the same. Source: docs/theory.md 3.8.
struct BodyPull {
    double force = 0.0;  ///< p, at an indentation of 0, > 0 repulsive [N]
    double slope = 0.0;  ///< g, d(force)/d(indentation) [N/m]; for an approach 1 + c g must be > 0

    bool operator==(const BodyPull&) const = default;

    [[nodiscard]] bool present() const noexcept { return force != 0.0 || slope != 0.0; }
    [[nodiscard]] double at(double indentation) const noexcept {  ///< [N]
        return force + (slope * indentation);
    }
    /// Compliance of the lever that the bare law is asked for [m/N]; the softest where this force
    /// outruns the lever. @param compliance its own
    [[nodiscard]] double compliance(double compliance) const noexcept {
        const double left = 1.0 + (compliance * slope);
        return left > 0.0 ? compliance / left : std::numeric_limits<double>::infinity();
    }
    /// Approach that the bare law is asked for [m], and back. @param compliance of the lever itself
    [[nodiscard]] double bareApproach(double approach, double compliance) const noexcept {
        return (approach - (compliance * force)) / (1.0 + (compliance * slope));
    }
    [[nodiscard]] double approach(double bareApproach, double compliance) const noexcept {
        return (bareApproach * (1.0 + (compliance * slope))) + (compliance * force);
    }
};

}  // namespace asperity
