#pragma once

#include "core/studies/extremes/HoldOutcome.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// One row a device: what it was, how it was judged and how far the handle moved.
/// @throw Error when the file cannot be written
void writeHolds(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds);

/// For people: verdicts by rate and delay, with and without coupling, to standard output.
void printHolds(const std::vector<HoldOutcome>& holds);

}  // namespace asperity
