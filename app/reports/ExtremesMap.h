#pragma once

#include "core/studies/extremes/ExtremesRegion.h"
#include "vtkplugins/pictures/ShareMaps.h"

namespace asperity {

/// The map of all laws over tip radius and reduced modulus, and of the whole tick over tip radius
/// and roughness: each cell is divided as its states were judged.
[[nodiscard]] ShareMapPage extremesMap(const std::vector<ExtremesRegion>& regions);

}  // namespace asperity
