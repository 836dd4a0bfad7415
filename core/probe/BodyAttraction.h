#pragma once

namespace asperity {

class BSplineSurface;
struct ProbeSystem;
struct TipState;

/// Attraction of the tip by the sample beside a contact.
struct BodyAttraction {
    double force = 0.0;  ///< along the contact's normal, < 0: it pulls [N]
    double share = 0.0;  ///< of the pull-off force 1.5 pi w R_eff
};

/// Returns the attraction that the law of the main contact leaves out: the van der Waals traction
/// H / (6 pi g^3) across the separation g of the tip's cap and a height field, less the same across
/// that to the paraboloid which the law has in place of the sample. Within the range of cohesion
/// attraction is the law's: g^3 / (g^3 + D_s^3)^2 in place of 1 / g^3, D_s the separation at its
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
