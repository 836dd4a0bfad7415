#pragma once

#include "core/Vector.h"
#include "core/contact/laws/ContactModel.h"

#include <span>

namespace asperity {

class BSplineSurface;
class HeightMoments;
struct ContactPair;
struct ProbeSystem;
struct TipState;

/// Parameters of the attraction, and of how finely it is summed.
struct BodyTraction {
    double tipRadius = 0.0;        ///< R [m]
    double workOfAdhesion = 0.0;   ///< w [J/m^2]
    double cohesiveRange = 0.0;    ///< across a gap: up to it attraction is the law's [m]
    double effectiveRadius = 0.0;  ///< of the main contact [m]
    double pullOff = 0.0;          ///< force that errors are held to shares of, > 0 [N]
};

/// Returns the parameters for a contact of this pair, its radius the effective one.
[[nodiscard]] BodyTraction bodyTraction(const ProbeSystem& system,
                                        const ContactPair& pair) noexcept;

/// Attraction of a tip by the sample beside its contacts, around one position of its apex.
struct BodyForce {
    Vector3 tip = Vector3::Zero();       ///< that position [m]
    double force = 0.0;                  ///< along the main contact's normal, < 0: it pulls [N]
    Vector3 gradient = Vector3::Zero();  ///< of it by the position [N/m]
    double bend = 0.0;                   ///< second derivative along z [N/m^2]
    double radius = 0.0;                 ///< effective one of the main contact [m]
    int squares = 0;                     ///< summed over

    /// Returns whether the gradient holds at another position: second order is at most `error` [N].
    /// Across the gradient the force changes as over an asperity of the contact's effective radius.
    [[nodiscard]] bool holdsAt(const Vector3& position, double error) const noexcept;
    /// The force at a position as a straight line of the indentation along a normal there.
    [[nodiscard]] BodyPull along(const Vector3& normal, const Vector3& position,
                                 double indentation) const noexcept;
};

/// Sums the van der Waals traction H/(6 pi) g^3/(g^3 + D_s^3)^2 across the separation g of the
/// tip's cap and the sample, less the same across that to the paraboloid which the law of each
/// contact has instead of the sample, as bodyAttraction() does, over squares of the scan: each as
/// large as mean and variance of its heights describe to a share of the pull-off force, down to a
/// quarter of a pixel. Gaps and elements are along z, so that it does not depend on any direction
/// in the plane and has, as a whole, a potential. Beyond the scan the sample goes on as at its
/// edge.
///
/// No allocation, at most some 1e4 squares. Valid where the slopes of the sample are small over the
/// part that attracts and where that is not deformed.
/// @param tip apex [m] @param points of contact on the surface, the main one first, at least one
/// @param normal of the main one
/// Source: docs/theory.md 3.8.
[[nodiscard]] BodyForce bodyForce(const HeightMoments& sample, const BodyTraction& traction,
                                  const Vector3& tip, std::span<const Vector3> points,
                                  const Vector3& normal) noexcept;

/// Attraction of the tip by the sample beside a contact.
struct BodyAttraction {
    double force = 0.0;  ///< along the contact's normal, < 0: it pulls [N]
    double share = 0.0;  ///< of the pull-off force 1.5 pi w R_eff
};

/// Returns the attraction that the law of the main contact leaves out: the van der Waals traction
/// H / (6 pi g^3) across the separation g of the tip's cap and a height field, less the same across
/// that to the paraboloid which the law has instead of the sample. Within the range of cohesion
/// attraction is the law's: g^3 / (g^3 + D_s^3)^2 instead of 1 / g^3, D_s the separation at its
/// end. 0 on a plane and on any sample that is its own paraboloid; 0 without adhesion.
///
/// Not for the tick: some 1e5 look-ups, a quarter of a pixel apart near the contact and a fiftieth
/// of the distance farther out. Valid where the slopes of the sample are small over the part that
/// attracts and where that is not deformed. What further contacts count is not taken off. Beyond
/// the scan the sample goes on as at its edge, parallel to the contact's plane.
/// Source: docs/theory.md 3.8.
[[nodiscard]] BodyAttraction bodyAttraction(const BSplineSurface& surface,
                                            const ProbeSystem& system,
                                            const TipState& state) noexcept;

}  // namespace asperity
