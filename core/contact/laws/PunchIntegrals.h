#pragma once

#include "core/contact/laws/TipPunch.h"

namespace asperity {

/// Integrals over the contacts between a contact radius a and the radius c of the cohesive zone
/// around it, of their elastic indentation d(t), in units of the sphere's radius.
struct ZoneIntegrals {
    double opening = 0.0;  ///< of (d(t) - d(a)) / sqrt(c^2 - t^2)
    double spread = 0.0;   ///< of d'(t) t / sqrt(c^2 - t^2), over c
    double work = 0.0;     ///< of (d(t) - d(a)) sqrt(c^2 - t^2)

    ZoneIntegrals& operator+=(const ZoneIntegrals& other) noexcept;
};

[[nodiscard]] ZoneIntegrals operator+(ZoneIntegrals one, const ZoneIntegrals& other) noexcept;
[[nodiscard]] ZoneIntegrals operator*(double factor, const ZoneIntegrals& integrals) noexcept;

/// Returns the integrals of a zone, to some 1e-12. Real-time safe. Source: docs/theory.md 4.8.
/// @param punch with a cone  @param width sqrt(c^2 - a^2)
[[nodiscard]] ZoneIntegrals zoneIntegrals(const TipPunch& punch, const PunchContact& contact,
                                          double width) noexcept;

/// Returns the integral of the elastic indentation d(t) / sqrt(r^2 - t^2) over the part of a
/// contact on the cone: by how much the cone leaves the surface at r unpressed.
/// @param run of the contact's edge, > 0  @param radius r, at least the contact's
[[nodiscard]] double coneTransform(const TipPunch& punch, double run, double radius) noexcept;

/// Returns the integral of d'(t) / sqrt(t^2 - r^2) over the part of a contact on the cone and
/// beyond r: pi times the pressure of a half-space of unit modulus at r that the cone causes.
/// @param run of the contact's edge, > 0  @param radius r, less than the contact's
[[nodiscard]] double conePressure(const TipPunch& punch, double run, double radius) noexcept;

}  // namespace asperity
