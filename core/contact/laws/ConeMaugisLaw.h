#pragma once

#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/laws/TipPunch.h"

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <limits>
#include <optional>

namespace asperity {

struct Rise;

/// A rigid sphere that goes on as a cone, on an elastic half-space with a cohesive zone of constant
/// stress: SphereCurve beyond the equator. In units of the sphere's radius and E*. A state with
/// contact is one coordinate of TipPunch, one without contact its cohesive radius.
///
/// With s = sqrt(c^2 - a^2), phi = atan(s / a), k = 2 sigma0 / E* and the elastic indentation d and
/// force p of the contact: indentation d(a) - k s, force p(a) - k (c^2 phi + a s), and c from
/// int_a^c (d(t) - d(a)) / sqrt(c^2 - t^2) dt + k (s phi - (c - a)) = pi/2 h0,
/// in which both terms are positive and rise with c. Source: docs/theory.md 4.8.
class ConeCurve {
public:
    /// @param cohesion 2 sigma0 / E*
    /// @param range of the cohesive stress over the tip radius, h0 / R, > 0
    /// @param coneHalfAngle > 0 [rad]
    ConeCurve(double cohesion, double range, double coneHalfAngle) noexcept;

    [[nodiscard]] const TipPunch& punch() const noexcept { return punch_; }
    [[nodiscard]] double cohesion() const noexcept { return cohesion_; }
    [[nodiscard]] double range() const noexcept { return range_; }
    /// Cohesive radius at which the surfaces first touch.
    [[nodiscard]] double touch() const noexcept { return touch_; }

    /// The rates are by the curve's own parameter, `perDepth` that of it by the coordinate.
    [[nodiscard]] SphereState contact(double coordinate) const noexcept;
    /// Rates by the cohesive radius, from 0 (free) to touch().
    [[nodiscard]] SphereState noncontact(double cohesiveRadius) const noexcept;
    /// Work done on separate bodies to reach the state along the curve, over E* R^3.
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;

private:
    struct Zone;

    [[nodiscard]] Zone zoneAt(const PunchContact& contact, double width) const noexcept;
    [[nodiscard]] double zoneGuess(const PunchContact& contact) const noexcept;
    [[nodiscard]] Zone solveZone(const PunchContact& contact) const noexcept;
    [[nodiscard]] double touchingRadius() const noexcept;
    [[nodiscard]] double tipHeight(double radius) const noexcept;

    double cohesion_;
    double range_;
    TipPunch punch_;
    double touch_;
};

/// A sphere that goes on as a cone, on a half-space with adhesion of a finite range:
/// SphereMaugisLaw beyond the equator, with contact or without. The four functions of ContactLaw.h;
/// real-time safe. Slow: see docs/physics.md.
///
/// As in SphereJkrLaw a slender cone, and a cohesive zone that reaches the cone before the surfaces
/// touch, may leave several stretches of stable states; which of them a tip is on follows from the
/// coordinate of the state before. The coordinate is that of TipPunch with contact, and from -1 (no
/// zone) to 0 (first touch) without. Source: docs/theory.md 4.8, 2.4, 2.5.
class ConeMaugisLaw {
public:
    /// @param pair with adhesion  @param cohesiveStress sigma0 [Pa], > 0
    /// @param coneHalfAngle > 0 [rad]
    ConeMaugisLaw(const ContactPair& pair, double cohesiveStress, double coneHalfAngle) noexcept;

    /// The state with this contact radius, stable or not [m].
    [[nodiscard]] LawPoint at(double contactRadius) const noexcept;
    /// The state without contact with this cohesive radius, 0 .. that of the first touch [m].
    [[nodiscard]] LawPoint apart(double cohesiveRadius) const noexcept;

    [[nodiscard]] LawPoint fold(double compliance) const noexcept;
    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate = 0.0) const noexcept;
    [[nodiscard]] double energy(const LawPoint& point) const noexcept;
    [[nodiscard]] double onset() const noexcept { return -curve_.range() * units_.length; }

    [[nodiscard]] double cohesiveStress() const noexcept { return cohesiveStress_; }  ///< [Pa]
    /// Transition parameter of the paraboloid of this radius.
    [[nodiscard]] double lambda() const noexcept { return lambda_; }

private:
    static constexpr std::size_t kApartSamples = 8;
    static constexpr std::size_t kSphereSamples = 10;
    static constexpr std::size_t kConeSamples = 16;
    static constexpr std::size_t kSamples = kApartSamples + kSphereSamples + kConeSamples;

    /// Coordinates at the ends of stable states, which lie between them.
    struct Stretch {
        double from = 0.0;
        double to = std::numeric_limits<double>::infinity();
    };
    using Stretches = boost::container::static_vector<Stretch, kSamples>;

    [[nodiscard]] SphereState stateAt(double coordinate) const noexcept;
    [[nodiscard]] LawPoint inSi(double coordinate) const noexcept;
    [[nodiscard]] double heldRate(double coordinate, double softness) const noexcept;
    [[nodiscard]] Rise heldAt(double coordinate, double softness) const noexcept;
    [[nodiscard]] double heldAtLoadFold(double softness) const noexcept;
    void placeSamples() noexcept;
    [[nodiscard]] double sampleAt(std::size_t index) const noexcept;
    void takeSamples() noexcept;
    [[nodiscard]] Stretches stretches(double softness) const noexcept;
    [[nodiscard]] double climb(double target, double softness, const Stretch& stretch,
                               double near) const noexcept;

    double cohesiveStress_;
    double lambda_;
    SphereUnits units_;
    ConeCurve curve_;
    double nearSample_ = 0.0;  ///< coordinate of the first sample with contact
    double farSample_ = 0.0;   ///< of the last one, beyond the joint
    double loadFold_ = 0.0;    ///< coordinate beyond which every lever holds the tip
    double loadFoldIndentation_ = 0.0;
    double loadFoldForce_ = 0.0;
    bool isSimple_ = true;  ///< one stretch of stable states, whatever the lever
    /// Softness from which a sample's state is no longer stable; infinite: on none.
    std::array<double, kSamples> softest_{};
};

}  // namespace asperity
