#pragma once

#include "app/runs/OutputFolder.h"
#include "core/fidelity/SceneNeeds.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// All files that `asperity tradeoff` leaves, the main table first.
[[nodiscard]] FolderContent tradeOffFiles();

/// Writes tradeoff.csv, frames.csv, rates.csv, compositions.csv and the figure tradeoff.png into a
/// folder.
/// @throw Error when a file cannot be written, or no display answers
void writeTradeOff(const std::filesystem::path& folder, const TradeOff& study);

/// @throw Error when the file cannot be written
void writeNeeds(const std::filesystem::path& path, const SceneNeeds& needs);

/// @throw Error when the file cannot be written
void writeDeformations(const std::filesystem::path& path,
                       const std::vector<DeformationResult>& results);

}  // namespace asperity
