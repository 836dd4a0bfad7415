#pragma once

#include "app/maps/ComparedMap.h"
#include "app/maps/MapFiles.h"
#include "vtkplugins/pictures/MapSheet.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

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
