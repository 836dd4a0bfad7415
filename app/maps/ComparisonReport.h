#pragma once

#include "app/maps/ComparedMap.h"
#include "app/maps/MapFiles.h"
#include "vtkplugins/pictures/MapSheet.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Says how much of the variance the prediction explains, or why that is not defined.
[[nodiscard]] std::string findingOn(const MapComparison& numbers);

/// One line for people: what was compared with what, and what came out.
[[nodiscard]] std::string sentenceOn(const ComparedMap& compared);

/// The comparison as JSON: docs/maps.md, all numbers in SI units.
[[nodiscard]] std::string comparisonJson(const MeasuredFile& file, const MapPlan& plan,
                                         std::span<const ComparedMap> maps);

/// Draws a sheet for each comparison: measured and predicted map, difference and residual, and the
/// measured values over the predicted ones with their line.
/// There is a QGuiApplication. @throw Error when no display answers, or a file cannot be written
void writeComparisonSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part,
                           std::span<const ComparedMap> maps);

/// All files of a map but those of a comparison.
/// @param withSheets whether pictures are drawn
[[nodiscard]] std::vector<std::filesystem::path> filesOf(const MapFiles& files, const MapPlan& plan,
                                                         bool withSheets);

/// A map as a sheet shows it, thinned to at most 1024 pixels along each side.
[[nodiscard]] SheetMap sheetMap(const MapPlan& plan, const std::string& name, const char* unit,
                                const RowReader& readRow);

/// Draws every quantity but the flags, whose numbers are no amounts, on sheets of six.
/// @throw Error when no display answers, or a file cannot be written
void writeMapSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part);

}  // namespace asperity
