#include "vtkplugins/paraview/module/GivenHeights.h"

#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

#include <array>
#include <limits>

namespace asperity {

namespace {

/// Calls visit(index, height) for each pixel from the top row on. VTK's rows go up.
template <class Visit>
void forEachPixel(int columns, int rows, vtkDataArray& heights, const LengthUnit& unit,
                  const Visit& visit) {
    std::size_t index = 0;
    for (int row = 0; row < rows; ++row) {
        const vtkIdType first = static_cast<vtkIdType>(rows - 1 - row) * columns;
        for (int column = 0; column < columns; ++column, ++index) {
            visit(index, unit.toMeters(heights.GetComponent(first + column, 0)));
        }
    }
}

/// @param pixelOf (height) -> value; of a finite height
template <class Map, class PixelOf>
void fill(Map& map, vtkDataArray& heights, const LengthUnit& unit, const PixelOf& pixelOf) {
    using Value = typename decltype(map.heights)::value_type;
    map.heights.resize(map.index(map.rows, 0));
    forEachPixel(map.columns, map.rows, heights, unit, [&](std::size_t index, double height) {
        if (isFiniteHeight(height)) {
            map.heights[index] = pixelOf(height);
            return;
        }
        map.heights[index] = std::numeric_limits<Value>::quiet_NaN();
        if (map.invalid.empty()) {
            map.invalid.resize(map.heights.size());
        }
        map.invalid[index] = true;
    });
}

/// As the reader of a large file: about the first height.
double datumOf(int columns, int rows, vtkDataArray& heights, const LengthUnit& unit) {
    double datum = std::numeric_limits<double>::quiet_NaN();
    forEachPixel(columns, rows, heights, unit, [&datum](std::size_t, double height) {
        if (!isFiniteHeight(datum) && isFiniteHeight(height)) {
            datum = height;
        }
    });
    return isFiniteHeight(datum) ? datum : 0.0;
}

template <class Map>
Map emptyMap(vtkImageData& image, const LengthUnit& unit) {
    const int* size = image.GetDimensions();
    Map map;
    map.columns = size[0];
    map.rows = size[1];
    map.pitchX = unit.toMeters(image.GetSpacing()[0]);
    map.pitchY = unit.toMeters(image.GetSpacing()[1]);
    return map;
}

}  // namespace

std::variant<HeightMap, ScanMap> givenHeights(vtkImageData& image, vtkDataArray& heights,
                                              const LengthUnit& unit) {
    if (image.GetDimensions()[2] != 1) {
        throw Error("the input has several layers along z: expected a height map, an image of one");
    }
    if (heights.GetNumberOfComponents() != 1 ||
        heights.GetNumberOfTuples() != image.GetNumberOfPoints()) {
        throw Error("the height array must have one value for each point of the input");
    }
    if (static_cast<std::size_t>(image.GetNumberOfPoints()) <= kLargeScan) {
        auto map = emptyMap<HeightMap>(image, unit);
        fill(map, heights, unit, [](double height) { return height; });
        return map;
    }
    auto map = emptyMap<ScanMap>(image, unit);
    map.datum = datumOf(map.columns, map.rows, heights, unit);
    fill(map, heights, unit,
         [&map](double height) { return static_cast<float>(height - map.datum); });
    return map;
}

}  // namespace asperity
