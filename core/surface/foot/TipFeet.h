#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/FootList.h"
#include "core/surface/foot/FootTracker.h"

#include <span>

namespace asperity {

/// Two feet nearer to each other than this are one, in tip radii.
inline constexpr double kSameFoot = 0.02;

/// The sphere that is looked at.
struct TipSphere {
    Vector3 center = Vector3::Zero();  ///< world [m]
    double radius = 0.0;               ///< [m]
};

/// Which feet of a sphere are looked for, and how hard.
struct FeetSought {
    double reach = 0.0;  ///< how far from the sphere's surface they may lie [m]
    FootEffort effort = FootEffort::Certified;
};

/// Feet of a sphere on a surface: in a valley that it does not fit there are several.
struct TipFeet {
    FootList list;  ///< the nearest first; at least one, which may lie out of reach
    /// Nearest: these are all; ManyFeet: there may be more, or are more than have room; Likely,
    /// NotSought: there may be more, with less effort than Certified.
    FootProof proof = FootProof::NotSought;
};

/// All feet of the sphere's center that lie within `reach` of the sphere's surface, or, where the
/// center lies below the surface, however far; `known` guesses save time. Allocation-free, bounded,
/// never throws.
[[nodiscard]] TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip, double reach,
                              std::span<const FootGuess> known) noexcept;

/// The same for one sphere after another, each near the last.
[[nodiscard]] TipFeet tipFeet(const BSplineSurface& surface, const TipSphere& tip,
                              const FeetSought& sought, std::span<const FootGuess> known,
                              FootTracker& tracker) noexcept;

}  // namespace asperity
