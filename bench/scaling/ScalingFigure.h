#pragma once

#include "bench/scaling/ScalingSweep.h"

#include <filesystem>
#include <span>

namespace asperity {

/// Draws the sweeps side by side on logarithmic axes: dots where it was measured, dashed the power
/// law whose slope the legend has.
/// @throw Error when no display answers, or the file cannot be written
void writeScalingFigure(const std::filesystem::path& path, std::span<const ScalingSweep> sweeps);

}  // namespace asperity
