#pragma once

#include <span>

namespace asperity {

/// The part of each pixel whose gap is below `range` [m], 0 .. 1, from the gap at its middle and
/// its slope to the neighbors: on a grid a cohesive zone's edge moves smoothly, not in steps of a
/// pixel. The work of separation of a pixel stays stress x range.
/// @param gaps of size x size pixels, row-major [m]  @param shares as many
void cohesiveShares(std::span<const double> gaps, int size, double range,
                    std::span<double> shares) noexcept;

}  // namespace asperity
