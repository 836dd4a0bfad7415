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
class SampleSurface {
public:
    // NOLINTBEGIN(google-explicit-constructor): either surface is a sample as it is
    SampleSurface(const BSplineSurface& field,
                  SearchEffort effort = SearchEffort::Certified) noexcept
        : surface_(&field), effort_(effort) {}
    /// Looked at with all effort.
    SampleSurface(const NurbsSurface& shape) noexcept : surface_(&shape) {}
    // NOLINTEND(google-explicit-constructor)

    /// The closest points of a tip, as on a height field (ContactPoints.h). On a NURBS surface
    /// neither guesses nor tracker are needed, and of the closest points beside the nearest one
    /// some may be missing.
    [[nodiscard]] ContactPoints contactPoints(const TipSphere& tip, double reach,
                                              std::span<const SearchGuess> known,
                                              ClosestPointTracker& tracker) const noexcept;

    /// A closest point of `query`, as on a height field (LocalClosestPoint.h); on a NURBS surface
    /// the one that lies nearest to the guess as seen from above.
    [[nodiscard]] ClosestPoint localClosestPoint(const Vector3& query,
                                                 const SearchGuess& guess) const noexcept;

private:
    std::variant<const BSplineSurface*, const NurbsSurface*> surface_;
    SearchEffort effort_ = SearchEffort::Certified;
};

}  // namespace asperity
