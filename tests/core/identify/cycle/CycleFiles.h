#pragma once

#include "core/identify/cycle/MeasuredCycle.h"

#include <cstdint>
#include <string>

namespace asperity::test {

/// A cycle of tests/reference/cycles, written by tests/physics/cycles.py, with white noise.
/// @param noise standard deviation as a share of the force range
[[nodiscard]] MeasuredCycle syntheticCycle(const std::string& name, double noise = 0.0,
                                           std::uint64_t seed = 1);

/// A curve of ../shared/data/curves/csv without its baseline: a line through the first `quiet`
/// share of the approach, and an offset by the last quarter of the retract.
[[nodiscard]] MeasuredCycle sharedCycle(const std::string& name, double stiffness, double quiet);

/// Every length, the works of adhesion and the stiffness times `factor`.
[[nodiscard]] MeasuredCycle scaled(const MeasuredCycle& cycle, double factor);

}  // namespace asperity::test
