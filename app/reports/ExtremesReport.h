#pragma once

#include "core/studies/extremes/ExtremesStudy.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// One row a region: how many of its states are worth what, and its largest errors.
/// @throw Error when the file cannot be written
void writeRegions(const std::filesystem::path& path, const std::vector<ExtremesRegion>& regions);

/// For people, to standard output. @param seconds that the study took
void printExtremes(const ExtremesFindings& findings, double seconds);

/// A sentence with X for every quantity, so that refusals of one kind can be counted.
[[nodiscard]] std::string kindOf(const std::string& sentence);

}  // namespace asperity
