#pragma once

#include "core/surface/closest/ClosestPoint.h"

#include <span>
#include <variant>

namespace asperity {

class BSplineSurface;
class ClosestPointTracker;
class NurbsSurface;
struct ContactPoints;
struct TipSphere;

/// The surface that a tip touches, a height field or a NURBS surface, and the effort of the search
/// for its closest points. A view: the surface must outlive it.
///
/// A tip whose sphere has its center below a height field touches it at one position, where the
/// tip's axis leaves the sample: all the sample around the center is in one contact with the tip,
/// which has several closest points, or jumps between them, where a bump is narrower than the
/// center is deep. On a plane the approach is the same, and where the center passes the surface
/// both positions are one.
class SampleSurface {
public:
    // NOLINTBEGIN(google-explicit-constructor): either surface is a sample as it is
    SampleSurface(const BSplineSurface& field,
                  SearchEffort effort = SearchEffort::Certified) noexcept
        : surface_(&field), effort_(effort) {}
    /// Looked at with all effort.
    SampleSurface(const NurbsSurface& shape) noexcept : surface_(&shape) {}
    // NOLINTEND(google-explicit-constructor)

    /// The contact points of a tip, as on a height field (ContactPoints.h), or the one on its axis
    /// where the center is below that. On a NURBS surface neither guesses nor tracker are needed,
    /// and of the closest points beside the nearest one some may be missing.
    [[nodiscard]] ContactPoints contactPoints(const TipSphere& tip, double reach,
                                              std::span<const SearchGuess> known,
                                              ClosestPointTracker& tracker) const noexcept;

    /// The contact point of a tip with its center here that follows from a guess: a closest point,
    /// as on a height field (LocalClosestPoint.h), or the one on the axis of a submerged tip; on a
    /// NURBS surface the one that lies nearest to the guess as seen from above.
    [[nodiscard]] ClosestPoint localContactPoint(const Vector3& center,
                                                 const SearchGuess& guess) const noexcept;

private:
    std::variant<const BSplineSurface*, const NurbsSurface*> surface_;
    SearchEffort effort_ = SearchEffort::Certified;
};

}  // namespace asperity
