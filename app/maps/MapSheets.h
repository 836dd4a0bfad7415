#pragma once

#include "app/maps/MapFiles.h"

namespace asperity {

/// Draws every quantity but the flags, whose numbers are no amounts, on sheets of six, thinned to
/// at most 1024 pixels along each side. @return how many sheets
/// @throw Error when no display answers, or a file cannot be written
int writeMapSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part);

}  // namespace asperity
