#pragma once

#include "app/commands/CurveFileOptions.h"
#include "core/io/curves/ForceCurveFile.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace asperity {

/// Opens the curves that a file holds beside its image; empty: none. Damaged ones are told on
/// standard error, and end nothing.
[[nodiscard]] std::optional<ForceCurveFile> curvesBeside(const std::string& file,
                                                         const CurveFileOptions& options);
/// Prints a file of force curves or of a thermal spectrum, for people or as JSON.
/// @return whether it is one @throw InputError where it is one that cannot be read
bool showWithoutImage(const std::string& file, const CurveFileOptions& options, bool json);

/// Facts on the curves of a file, in SI: all of them, or the one that is meant. A curve that cannot
/// be read has its reason instead. @throw InputError where there is no curve of the index
[[nodiscard]] nlohmann::ordered_json curvesJson(const ForceCurveFile& file,
                                                const CurveFileOptions& options);
/// The same for people, of the first curves of many. @throw the same
void printCurves(const ForceCurveFile& file, const CurveFileOptions& options);

/// Returns what a fit needs and the curve lacks: "spring constant"; empty: nothing.
[[nodiscard]] std::vector<std::string> missingIn(const MeasuredForceCurve& curve);

}  // namespace asperity
