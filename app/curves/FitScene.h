#pragma once

#include "app/curves/FitFiles.h"

#include <filesystem>
#include <string>

namespace asperity {

/// Returns why no scene has what a curve was found to be; empty: one has.
[[nodiscard]] std::string refusalOfScene(const FittedCurve& curve);

/// Writes material.toml, probe.toml and scene.toml: a flat sample with the law, the numbers and the
/// deviations that were found, under a rigid tip on the lever that was found. What the curve does
/// not say, such as friction and the plan of the lever, is that of the default scene.
/// @throw Error where refusalOfScene() gives a reason, or a file cannot be written
void writeFitScene(const std::filesystem::path& folder, const FittedCurve& curve);

}  // namespace asperity
