#pragma once

#include "app/maps/MapFiles.h"

namespace asperity {

/// How many sheets of pictures a map has.
[[nodiscard]] int sheetCount(const MapPlan& plan);

/// Draws every quantity but the flags, whose numbers are no amounts, on sheets of six, thinned to
/// at most 1024 pixels along each side.
/// @throw Error when no display answers, or a file cannot be written
void writeMapSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part);

}  // namespace asperity
