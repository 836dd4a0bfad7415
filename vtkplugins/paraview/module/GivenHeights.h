#pragma once

#include "core/surface/HeightMap.h"
#include "vtkplugins/paraview/module/LengthUnit.h"

#include <variant>

class vtkDataArray;
class vtkImageData;

namespace asperity {

/// The heights of an image, in the precision that a scene of it is built in: as those of a file.
/// @param image with a single layer @param heights a value for each of its points
/// @throw Error when the image is no height map
[[nodiscard]] std::variant<HeightMap, ScanMap>
givenHeights(vtkImageData& image, vtkDataArray& heights, const LengthUnit& unit);

}  // namespace asperity
