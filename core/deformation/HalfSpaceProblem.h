#pragma once

#include "core/contact/halfspace/HalfSpaceContact.h"
#include "core/probe/TipEquilibrium.h"

#include <cmath>

namespace asperity {

struct Scene;

/// A square patch of pixels around the closest point, in its tangent plane.
struct HalfSpacePatch {
    int samples = 0;         ///< per side
    double halfWidth = 0.0;  ///< [m]

    [[nodiscard]] double pitch() const noexcept { return 2.0 * halfWidth / samples; }
    /// Of the middle of a pixel, from the patch's [m].
    [[nodiscard]] double place(int index) const noexcept {
        return (index - 0.5 * (samples - 1)) * pitch();
    }
    /// Calls visit(distance of a pixel from the middle [m]) for each pixel, row-major.
    template <class Visit>
    void forEachDistance(const Visit& visit) const {
        for (int row = 0; row < samples; ++row) {
            for (int column = 0; column < samples; ++column) {
                visit(std::hypot(place(column), place(row)));
            }
        }
    }
};

/// Tip and topography at a state of the believed contact law, which is bonded.
[[nodiscard]] HalfSpaceContact halfSpaceContact(const Scene& scene, const TipState& state,
                                                const HalfSpacePatch& patch);

/// What the contact law says that acts there.
[[nodiscard]] SurfaceTraction closedFormTraction(const Scene& scene, const TipState& state,
                                                 const HalfSpacePatch& patch);

/// What the law adds to the force of bonded bodies beyond the pressure in contact and cohesive
/// zone: the tail of the split law, a water bridge [N].
[[nodiscard]] double forceBeyondZone(const Scene& scene, const TipState& state);

}  // namespace asperity
