#include "vtkplugins/io/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>

namespace asperity {

namespace {

/// Row of the image that is the n-th from the bottom.
int imageRow(const HeightMap& map, int fromBottom) { return map.rows - 1 - fromBottom; }

bool hasHeight(const HeightMap& map, int row, int column) {
    return map.isValid(row, column) && std::isfinite(map.at(row, column));
}

/// Heights from the bottom row up, as VTK numbers points.
vtkSmartPointer<vtkDoubleArray> heightArray(const HeightMap& map) {
    auto heights = vtkSmartPointer<vtkDoubleArray>::New();
    heights->SetName("height");
    heights->SetNumberOfTuples(static_cast<vtkIdType>(map.heights.size()));
    vtkIdType id = 0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column, ++id) {
            heights->SetValue(id, map.at(imageRow(map, row), column));
        }
    }
    return heights;
}

vtkSmartPointer<vtkImageData> imageOf(const HeightMap& map) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(map.columns, map.rows, 1);
    image->SetSpacing(map.pitchX, map.pitchY, 1.0);
    image->SetOrigin(0.5 * map.pitchX, 0.5 * map.pitchY, 0.0);
    image->GetPointData()->SetScalars(heightArray(map));
    vtkNew<vtkUnsignedCharArray> valid;
    valid->SetName("valid");
    bool allValid = true;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            const bool good = hasHeight(map, imageRow(map, row), column);
            valid->InsertNextValue(good ? 1 : 0);
            allValid = allValid && good;
        }
    }
    if (!allValid) {
        image->GetPointData()->AddArray(valid);
    }
    return image;
}

vtkSmartPointer<vtkPoints> pointsOf(const HeightMap& map) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(map.heights.size()));
    vtkIdType id = 0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column, ++id) {
            const double height = map.at(imageRow(map, row), column);
            points->SetPoint(id, (column + 0.5) * map.pitchX, (row + 0.5) * map.pitchY,
                             std::isfinite(height) ? height : 0.0);
        }
    }
    return points;
}

/// Two triangles, counter-clockwise from above, for each four pixels that all have a height.
vtkSmartPointer<vtkPolyData> meshOf(const HeightMap& map, const std::filesystem::path& path) {
    vtkNew<vtkCellArray> triangles;
    for (int row = 0; row + 1 < map.rows; ++row) {
        for (int column = 0; column + 1 < map.columns; ++column) {
            const int lower = imageRow(map, row);
            if (!hasHeight(map, lower, column) || !hasHeight(map, lower, column + 1) ||
                !hasHeight(map, lower - 1, column) || !hasHeight(map, lower - 1, column + 1)) {
                continue;
            }
            const vtkIdType corner = static_cast<vtkIdType>(row) * map.columns + column;
            const vtkIdType above = corner + map.columns;
            triangles->InsertNextCell({corner, corner + 1, above + 1});
            triangles->InsertNextCell({corner, above + 1, above});
        }
    }
    if (triangles->GetNumberOfCells() == 0) {
        throw Error(path.string() + ": the map has no 2 x 2 valid pixels to make a surface of");
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(pointsOf(map));
    mesh->SetPolys(triangles);
    mesh->GetPointData()->SetScalars(heightArray(map));
    return mesh;
}

template <typename Writer>
void write(Writer* writer, vtkDataObject* data, const std::filesystem::path& path) {
    const TemporaryFile file(path);
    writer->SetInputData(data);
    writer->SetFileName(file.path().c_str());
    if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError) {
        throw Error(path.string() + ": writing stopped half-way (disk full?)");
    }
    file.commit();
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace

bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightMap& map) {
    const std::string extension = lowerCase(path.extension().string());
    if (extension != ".vti" && extension != ".vtp" && extension != ".stl") {
        return false;
    }
    requireUsable(map);
    if (extension == ".vti") {
        const vtkNew<vtkXMLImageDataWriter> writer;
        write(writer.Get(), imageOf(map), path);
    } else if (extension == ".vtp") {
        const vtkNew<vtkXMLPolyDataWriter> writer;
        write(writer.Get(), meshOf(map, path), path);
    } else {
        const vtkNew<vtkSTLWriter> writer;
        writer->SetFileTypeToBinary();
        writer->SetHeader("Asperity height map; one unit is one metre");
        write(writer.Get(), meshOf(map, path), path);
    }
    return true;
}

}  // namespace asperity
