#pragma once

#include "core/uncertainty/Budget.h"

#include <string>

namespace asperity {

/// A result with what is open in it, by prefix, and the inputs that make up most of the second
/// deviation: "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing, k)". A part that is 0 is left out. A
/// shift that matters beside the deviations follows: ", too high by 2 (imaging tip)".
/// @param unit SI
[[nodiscard]] std::string budgetText(const Budget& budget, const char* unit);

/// What smoothing and pixels move a result by, where that is more than the tolerance; else empty:
/// "smoothing and pixels move the pull-off force by 31 %, more than the tolerance of 5 %".
/// @param name of the result @param tolerance of the scene, relative
[[nodiscard]] std::string resolutionText(const Budget& budget, const char* name, double tolerance);

}  // namespace asperity
