#pragma once

#include "core/fidelity/extremes/ExtremesStudy.h"

namespace asperity {

/// A tip on a random rough surface.
struct RoughPlace {
    double tipRadius = 0.0;  ///< [m]
    double roughness = 0.0;  ///< rms height over tip radius
};

/// Runs of the whole tick with a scripted hand, with every effort of the foot search; the reference
/// is the certified search.
[[nodiscard]] ExtremesFindings tickExtremes(const TickGrid& grid, const RoughPlace& place);

}  // namespace asperity
