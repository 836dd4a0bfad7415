#pragma once

#include "app/commands/CurveFileOptions.h"
#include "core/curves/ThermalSpectrum.h"
#include "core/io/curves/ForceCurveFile.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace asperity {

/// Opens the force curves of a file; empty: it is of no type of curves.
/// @throw InputError where it is one that cannot be read
[[nodiscard]] std::optional<ForceCurveFile> openCurves(const std::string& file,
                                                       const CurveFileOptions& options);

/// Facts on the curves of a file, in SI: all of them, or the one that is meant. A curve that cannot
/// be read has its reason instead. @throw InputError where there is no curve of the index
[[nodiscard]] nlohmann::ordered_json curvesJson(const ForceCurveFile& file,
                                                const CurveFileOptions& options);
/// The same for people, of the first curves of many. @throw the same
void printCurves(const ForceCurveFile& file, const CurveFileOptions& options);

[[nodiscard]] nlohmann::ordered_json spectrumJson(const ThermalSpectrum& spectrum);
void printSpectrum(const ThermalSpectrum& spectrum);

/// Returns what a fit needs and the curve lacks: "spring constant"; empty: nothing.
[[nodiscard]] std::vector<std::string> missingIn(const MeasuredForceCurve& curve);

}  // namespace asperity
