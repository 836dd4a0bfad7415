#pragma once

#include "core/Vector.h"
#include "core/scene/Validity.h"

#include <cstdint>

namespace asperity {

class BSplineSurface;
struct ClosestPoint;
class HeightMoments;
struct ProbeSystem;
struct Scene;
struct TipState;

/// Returns where the topography under a tip is not what one effective radius makes of it. Nothing
/// for exact shapes and models without the sample's curvature. No allocation, at most some 100
/// look-ups of the surface.
///
/// - curvature unresolved: what smoothing and pixels have blurred, to first order l^2/2 times the
///   Laplacian (l^2: the variance of the low-pass and of a pixel), changes R_eff by more than a
///   tenth;
/// - contact beyond the asperity: along the contact's rim the surface leaves the paraboloid of the
///   contact point, averaged over all directions and at the radius that weighs as the contact's
///   pressure does, by more than a tenth of the gap r^2/(2 R_eff) there;
/// - attraction of the sample beside it: shareBeside() exceeds the scene's tolerance where the
///   model leaves it out. What other contact points carry is not taken off.
///
/// Each is a ratio: lengths, forces and energies scaled together change nothing, but for D0, the
/// atomic separation of two solids.
/// Source: docs/theory.md 1.1, 3.8.
[[nodiscard]] ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system,
                                             const TipState& state) noexcept;

/// Attraction of a tip by the sample beside its contact, see bodyForce(), over the pull-off force
/// 1.5 pi w R_eff; < 0: it pulls. Sought where R is more than 1.5 R_eff: below, the law's tail has
/// all but a twentieth of it.
/// @param tip apex [m] @param place its contact
[[nodiscard]] double shareBeside(const HeightMoments& sample, const ProbeSystem& system,
                                 const Vector3& tip, const ClosestPoint& place,
                                 double effectiveRadius) noexcept;

/// Whether the tip is more than 1.5 times as blunt as the contact anywhere that it comes down on
/// the scan at one of 8 x 8 positions, and adheres.
[[nodiscard]] bool isBluntTip(const BSplineSurface& surface, const ProbeSystem& system) noexcept;

/// Whether shareBeside() exceeds a tolerance at any of these: whether a scene has the term before
/// its model is fitted.
[[nodiscard]] bool isAttractedBeside(const HeightMoments& sample, const ProbeSystem& system,
                                     double tolerance) noexcept;

/// What asperityValidity() of one tick leaves to the next. Its look-ups cost a tenth of a tick, and
/// nobody reads a flag a thousand times a second: they are made in the first tick of a contact and
/// in every eighth after it.
struct AsperityMemory {
    std::uint32_t flags = 0;    ///< bits of the last flags
    std::uint32_t holdFor = 0;  ///< further ticks of the contact; 0: none is known

    bool operator==(const AsperityMemory&) const = default;
};

/// The same for one tick of many, at most seven ticks old.
[[nodiscard]] ValidityFlags asperityValidity(const Scene& scene, const ProbeSystem& system,
                                             const TipState& state,
                                             AsperityMemory& memory) noexcept;

}  // namespace asperity
