#pragma once

#include "core/probe/ProbeSystem.h"
#include "core/scene/Settings.h"

namespace asperity {

/// The worst that a tip meets on its sample.
struct TipLoad {
    double stiffness = 0.0;  ///< largest, of the lever in series with the contact [N/m]
    double adhesion = 0.0;   ///< by which the sample holds the tip back, at most, >= 0 [N]
};

/// Stiffness of springs in series [N/m]; docs/theory.md 7.1.
[[nodiscard]] double inSeries(double first, double second) noexcept;

/// Along the normal of a flat sample. With the tip under control the base makes up for the lever,
/// and the device meets the contact alone. A contact stiffens as it is pressed, so that its
/// stiffness is that under `largestForce` [N]; the adhesion is the pull-off force of the contact
/// law, under a load that does not give way, with a meniscus where there is one. Source:
/// docs/haptics.md.
[[nodiscard]] TipLoad tipLoad(const ProbeSystem& system, double largestForce,
                              PositionControl control = PositionControl::Base) noexcept;

}  // namespace asperity
