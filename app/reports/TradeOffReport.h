#pragma once

#include "app/runs/OutputFolder.h"
#include "core/fidelity/RequiredTerms.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// All three for people, to standard output. @param tolerance of errors, as a share
void printTradeOff(const TradeOff& study, double tolerance);
void printNeeds(const RequiredTerms& needs);
void printDeformations(const std::vector<DeformationResult>& results);

/// All files that `asperity tradeoff` leaves, the main table first.
[[nodiscard]] FolderContent tradeOffFiles();

/// Writes tradeoff.csv, frames.csv, rates.csv, compositions.csv and the figure tradeoff.png into a
/// folder.
/// @throw Error when a file cannot be written, or no display answers
void writeTradeOff(const std::filesystem::path& folder, const TradeOff& study);

/// @throw Error when the file cannot be written
void writeNeeds(const std::filesystem::path& path, const RequiredTerms& needs);

/// @throw Error when the file cannot be written
void writeDeformations(const std::filesystem::path& path,
                       const std::vector<DeformationResult>& results);

}  // namespace asperity
