#pragma once

#include "core/studies/extremes/BenchHold.h"
#include "core/studies/extremes/ExtremesRegion.h"
#include "core/studies/extremes/ExtremesStudy.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// One row a region: how many of its states are worth what, and its largest errors.
/// @throw Error when the file cannot be written
void writeRegions(const std::filesystem::path& path, const std::vector<ExtremesRegion>& regions);

/// Prints the findings for people. @param seconds that the study took
void printExtremes(const ExtremesFindings& findings, double seconds);

/// A sentence with X for every quantity, so that refusals of one kind can be counted.
[[nodiscard]] std::string kindOf(const std::string& sentence);

/// One row a device: what it was, how it was judged and how far the handle moved.
/// @throw Error when the file cannot be written
void writeHolds(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds);

/// Prints verdicts by rate and delay for people, with and without coupling.
void printHolds(const std::vector<HoldOutcome>& holds);

// Tables of cells, each divided as its states were judged, as PNG. There is a QGuiApplication.

/// Draws the map of all laws over tip radius and reduced modulus, and of the whole tick over tip
/// radius and roughness. @throw Error
void writeExtremesMap(const std::filesystem::path& path,
                      const std::vector<ExtremesRegion>& regions);

/// Draws what becomes of a device with and without a coupling, over the loop's rate: by the delay
/// and by the decade of the contact's stiffness at the device. @throw Error
void writeCouplingMap(const std::filesystem::path& path, const std::vector<HoldOutcome>& holds);

}  // namespace asperity
