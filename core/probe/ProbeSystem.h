#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"
#include "core/probe/CantileverModes.h"
#include "core/probe/DetectorCalibration.h"
#include "core/probe/MaterialMaps.h"
#include "core/probe/TimedContact.h"

#include <memory>

namespace asperity {

inline constexpr double kRestSpeed = 1e-9;  ///< v0, below which friction fades [m/s]

/// Sliding of a tip over a surface: direction of friction and how surely it has one.
struct Sliding {
    Vector3 friction = Vector3::Zero();  ///< unit, against the motion; any tangent at rest
    double certainty = 0.0;              ///< g = |v_t| / sqrt(|v_t|^2 + v0^2), v0 = kRestSpeed
    double doubt = 1.0;                  ///< sqrt(1 - g^2)

    /// Direction of friction, fading smoothly to zero at rest.
    [[nodiscard]] Vector3 slip() const noexcept { return certainty * friction; }
};

/// Sliding of a tip that moves with `velocity` [m/s] over a surface with unit `normal`, both in one
/// frame. Source: docs/theory.md 6.2, 6.5.
[[nodiscard]] Sliding slidingOf(const Vector3& normal, const Vector3& velocity) noexcept;

/// Friction of tip on sample, T = mu N + tau A, never negative. Source: docs/theory.md 8.
struct Friction {
    double coefficient = 0.0;    ///< mu
    double shearStrength = 0.0;  ///< tau [Pa]

    bool operator==(const Friction&) const = default;
};

class HeightMoments;

/// Tip, lever and sample material taken together: what decides the force at a given base position.
/// A scene has two of them: what is true (inside the simulated instrument) and what we believe.
struct ProbeSystem {
    ContactModel contact;
    Cantilever cantilever;
    Friction friction;
    TimeTerms time = {};    ///< of sample and liquid
    bool curvature = true;  ///< whether the sample's curvature at the closest point counts
    /// The sample that attracts the tip beside its contacts, see bodyForce(); null: none does.
    std::shared_ptr<const HeightMoments> beside = nullptr;
    /// Material of the sample at each position, instead of the pair and the coefficient above,
    /// which describe its stiffest and most adhesive parts; null: the same everywhere.
    std::shared_ptr<const MaterialField> field = nullptr;

    /// Returns whether the sample beside a contact attracts the tip: only a law with a van der
    /// Waals tail has attraction of a long range, and only one of the sample's curvature has an
    /// asperity.
    [[nodiscard]] bool attractsBeside() const noexcept {
        return beside != nullptr && hasTail(contact.law()) && takesCurvature();
    }
    /// Returns whether a contact has the effective radius of its position, not that of the tip.
    [[nodiscard]] bool takesCurvature() const noexcept {
        return curvature && !isSphere(contact.law());
    }
    [[nodiscard]] double tipRadius() const noexcept { return contact.pair().tipRadius; }  ///< [m]

    /// Returns the pair that the tip meets at a point of the surface under an effective radius [m].
    [[nodiscard]] ContactPair pairAt(const Vector3& point, double effectiveRadius) const noexcept;
    [[nodiscard]] Friction frictionAt(const Vector3& point) const noexcept;
};

/// All that a probe file says: the lever and how its slopes are read.
struct ProbeDescription {
    CantileverGeometry lever;
    DetectorCalibration detector;
    std::string source = {};  ///< where its numbers come from, for people

    bool operator==(const ProbeDescription&) const = default;
};

}  // namespace asperity
