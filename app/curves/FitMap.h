#pragma once

#include "app/curves/FitFiles.h"
#include "core/io/curves/StoredCurves.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Fitted curves of one file on the grid that they were measured on.
struct FitMap {
    CurveGrid grid;
    std::vector<FittedCurve> curves;
};

/// Returns why a map has no images; empty: it has some.
[[nodiscard]] std::string refusalOfMap(const FitMap& map);

/// Writes modulus, adhesion, contact point and residual as images of one .gwy file, each value with
/// its deviation by noise and by calibration. Pixels without a fitted curve hold no data.
/// @throw Error where refusalOfMap() gives a reason, or the file cannot be written
void writeFitMap(const std::filesystem::path& path, const FitMap& map);

}  // namespace asperity
