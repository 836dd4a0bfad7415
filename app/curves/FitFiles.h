#pragma once

#include "core/identify/cycle/CycleIdentification.h"
#include "core/io/curves/StoredCurves.h"

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A curve of a file that was fitted.
struct FittedCurve {
    std::string file;        ///< as the user gave it
    std::size_t index = 0;   ///< in the file
    std::string sha256;      ///< of the file
    std::string error = {};  ///< why it could not be read; empty: it was
    std::optional<CurvePosition> position = {};
    std::optional<CurveCell> cell = {};   ///< in the grid of its file
    std::string heightChannel = {};       ///< that the base was read from
    std::vector<std::string> notes = {};  ///< of the reader
    CurveIdentification found = {};
    std::optional<ModelComparison> comparison = {};
};

/// Returns what fit.json says of a curve.
[[nodiscard]] nlohmann::ordered_json fitJson(const FittedCurve& curve);

// The files of one curve, see docs/measured.md. Each is written whole or not at all. @throw Error

void writeFitJson(const std::filesystem::path& path, const nlohmann::ordered_json& json);
/// Writes the measured samples: as calibrated, without baseline, over the separation.
void writeMeasuredCurve(const std::filesystem::path& path, const FittedCurve& curve);
/// Writes the simulation from the motion of the base alone, and the fit.
void writeSimulatedCurve(const std::filesystem::path& path, const FittedCurve& curve);
/// Draws measurement and simulation over separation and base; needs a QGuiApplication.
void writeFitFigure(const std::filesystem::path& path, const FittedCurve& curve);

/// "matched: youngs_modulus_pa 344 kPa ...": what a command prints of a curve, lines without ends.
[[nodiscard]] std::vector<std::string> fitSummary(const FittedCurve& curve);

}  // namespace asperity
