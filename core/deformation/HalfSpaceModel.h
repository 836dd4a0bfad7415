#pragma once

#include "core/contact/halfspace/HalfSpaceSolver.h"
#include "core/deformation/HalfSpaceAnswer.h"

#include <optional>
#include <stop_token>

namespace asperity {

struct Scene;

/// Solves for the deformed surface around the tip, on the scan's own topography in the tangent
/// plane at the closest point and with the exact sphere as tip, at the indentation of the tick's
/// state. Each answer starts from the one before where that fits, else from the closed form. The
/// cohesive zone is the contact law's; of a law that adheres without one (DMT, JKR) nothing is
/// solved, since with any zone of finite range the half-space would answer for another law. One
/// object a thread; off the tick: allocates, takes milliseconds. Source: docs/theory.md 2, 3.4, 4.
class HalfSpaceModel {
public:
    static constexpr int kSamples = 128;  ///< pixels per side of a patch

    /// @param samples per side of the patches
    explicit HalfSpaceModel(int samples = kSamples, HalfSpaceLimits limits = {});

    /// @param stop ends the search early
    [[nodiscard]] HalfSpaceAnswer solve(const Scene& scene, const TipState& state,
                                        const std::stop_token& stop = {});

private:
    /// A solution to start the next one from.
    struct Kept {
        double halfWidth = 0.0;  ///< of its patch [m]
        SurfaceTraction traction;
    };
    [[nodiscard]] double halfWidthFor(const TipState& state, double tipRadius) const;

    int samples_;
    HalfSpaceSolver solver_;
    std::optional<Kept> kept_;
};

}  // namespace asperity
