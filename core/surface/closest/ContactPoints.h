#pragma once

#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPointList.h"
#include "core/surface/closest/ClosestPointTracker.h"

#include <span>

namespace asperity {

/// Two closest points nearer to each other than this are one, in tip radii.
inline constexpr double kSamePoint = 0.02;

/// The sphere that is looked at.
struct TipSphere {
    Vector3 center = Vector3::Zero();  ///< world [m]
    double radius = 0.0;               ///< [m]
};

/// Closest points of a sphere that are looked for, with the effort.
struct ContactPointSearch {
    double reach = 0.0;  ///< how far from the sphere's surface they may lie [m]
    SearchEffort effort = SearchEffort::Certified;
};

/// Points where a sphere comes closest to a surface: several in a valley that it does not fit.
struct ContactPoints {
    ClosestPointList list;  ///< the nearest first; at least one, which may lie out of reach
    /// Nearest: these are all; TooManyPoints: there may be more, or are more than kMaxMinima;
    /// Likely, NotSought: there may be more, with less effort than Certified.
    SearchProof proof = SearchProof::NotSought;
    /// Some of those within reach are more than half a pixel from one that counts for them, too:
    /// a blunt tip may bear on both.
    bool joined = false;
};

/// All closest points of the sphere's center that lie within `reach` of the sphere's surface, or,
/// where the center lies below the surface, however far; `known` guesses save time.
/// Allocation-free, bounded, never throws.
[[nodiscard]] ContactPoints contactPoints(const BSplineSurface& surface, const TipSphere& tip,
                                          double reach,
                                          std::span<const SearchGuess> known) noexcept;

/// The same for one sphere after another, each near the last.
[[nodiscard]] ContactPoints contactPoints(const BSplineSurface& surface, const TipSphere& tip,
                                          const ContactPointSearch& sought,
                                          std::span<const SearchGuess> known,
                                          ClosestPointTracker& tracker) noexcept;

}  // namespace asperity
