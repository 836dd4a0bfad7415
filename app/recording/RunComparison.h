#pragma once

#include "app/recording/ForceTrace.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// The normal forces of two runs at the same time since the start of each.
struct ComparedForces {
    double time = 0.0;    ///< since the start [s]
    double first = 0.0;   ///< [N]
    double second = 0.0;  ///< between two ticks linearly interpolated [N]

    [[nodiscard]] double difference() const noexcept { return second - first; }  ///< [N]
};

/// By how much the normal force of a second run differs from that of a first one: second minus
/// first, at the ticks of the first one that lie within both runs.
struct RunComparison {
    std::vector<ComparedForces> ticks;  ///< in order; at least one
    std::size_t excluded = 0;  ///< ticks within both in which one of the forces is not known
    double overlap = 0.0;      ///< for how long both runs go on [s]
    double mean = 0.0;         ///< of the differences [N]
    double rms = 0.0;          ///< root of the mean of their squares [N]
    ComparedForces largest;    ///< in magnitude, the first one of equal ones
};

/// Runs may differ in rate and length. Where a force of the second run is not known, none is
/// interpolated over it.
/// @throw Error where no tick is left to compare
[[nodiscard]] RunComparison compareRuns(const ForceTrace& first, const ForceTrace& second);

}  // namespace asperity
