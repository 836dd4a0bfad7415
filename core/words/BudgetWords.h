#pragma once

#include "core/uncertainty/Budget.h"

#include <string>

namespace asperity {

/// A result with what is open in it, by prefix, and the inputs that make up most of the second
/// deviation: "16.9 nN ± 0.2 (noise) ± 4 (heights, smoothing, k)". A part that is 0 is
/// left out. What matters beside them follows: " ± 3 (terms left out)" of the model, a part that is
/// not known, " ± ? (model and calibration: several contacts at once)", and a shift, ", too high by
/// 2 (imaging tip)".
/// @param unit SI
[[nodiscard]] std::string budgetText(const Budget& budget, const char* unit);

/// Returns what adds most to a result's uncertainty, or that it is not known; "–": nothing.
[[nodiscard]] std::string mostBy(const Budget& budget);

/// Returns a note on what is not known of a result, and why: "the uncertainty of the pull-off force
/// from model and calibration is not known: several contacts at once". Empty where all is known.
/// @param name of the result
[[nodiscard]] std::string unknownText(const Budget& budget, const char* name);

/// Returns a note on the larger of two effects, where it exceeds the tolerance: that of smoothing
/// and pixels ("smoothing and pixels move the pull-off force by 31 %, more than the tolerance of 5
/// %"), and that of roughness hidden by noise (Budget::hidden). Empty where both are within it.
/// @param name of the result @param tolerance of the scene, relative
[[nodiscard]] std::string resolutionText(const Budget& budget, const char* name, double tolerance);

}  // namespace asperity
