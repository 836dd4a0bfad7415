#pragma once

#include "core/surface/foot/SurfaceFoot.h"

#include <span>
#include <variant>

namespace asperity {

class BSplineSurface;
class FootTracker;
class NurbsSurface;
struct TipFeet;
struct TipSphere;

/// What a tip touches, a height field or a NURBS surface, and how hard its feet are looked for
/// there. A view: the surface must outlive it.
class TouchedSurface {
public:
    // NOLINTBEGIN(google-explicit-constructor): either surface can be touched as it is
    TouchedSurface(const BSplineSurface& field, FootEffort effort = FootEffort::Certified) noexcept
        : surface_(&field), effort_(effort) {}
    /// Looked at with all effort.
    TouchedSurface(const NurbsSurface& shape) noexcept : surface_(&shape) {}
    // NOLINTEND(google-explicit-constructor)

    /// The feet of a tip, as on a height field (TipFeet.h). On a NURBS surface neither guesses nor
    /// tracker are needed, and of the feet beside the nearest one some may be missing.
    [[nodiscard]] TipFeet tipFeet(const TipSphere& tip, double reach,
                                  std::span<const FootGuess> known,
                                  FootTracker& tracker) const noexcept;

    /// A foot of `query`, as on a height field (LocalFoot.h); on a NURBS surface the one that lies
    /// nearest to the guess as seen from above.
    [[nodiscard]] SurfaceFoot localFoot(const Vector3& query,
                                        const FootGuess& guess) const noexcept;

private:
    std::variant<const BSplineSurface*, const NurbsSurface*> surface_;
    FootEffort effort_ = FootEffort::Certified;
};

}  // namespace asperity
