#include "vtkplugins/io/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
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
#include <cctype>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// Heights from the bottom row up, as VTK numbers points.
vtkSmartPointer<vtkDoubleArray> heightArray(const HeightRows& map, Progress* progress) {
    auto heights = vtkSmartPointer<vtkDoubleArray>::New();
    heights->SetName("height");
    heights->SetNumberOfTuples(static_cast<vtkIdType>(map.columns) * map.rows);
    forEachRow(map, progress, [&](int row, const std::vector<double>& values) {
        const auto first = static_cast<vtkIdType>(map.rows - 1 - row) * map.columns;
        std::ranges::copy(values, heights->GetPointer(first));
    });
    return heights;
}

bool hasHeight(vtkDoubleArray* heights, vtkIdType point) {
    return isFiniteHeight(heights->GetValue(point));
}

vtkSmartPointer<vtkImageData> imageOf(const HeightRows& map, vtkDoubleArray* heights) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(map.columns, map.rows, 1);
    image->SetSpacing(map.pitchX, map.pitchY, 1.0);
    image->SetOrigin(0.5 * map.pitchX, 0.5 * map.pitchY, 0.0);
    image->GetPointData()->SetScalars(heights);
    const vtkIdType points = heights->GetNumberOfTuples();
    vtkIdType point = 0;
    while (point < points && hasHeight(heights, point)) {
        ++point;
    }
    if (point == points) {
        return image;
    }
    vtkNew<vtkUnsignedCharArray> valid;
    valid->SetName("valid");
    valid->SetNumberOfTuples(points);
    for (point = 0; point < points; ++point) {
        valid->SetValue(point, hasHeight(heights, point) ? 1 : 0);
    }
    image->GetPointData()->AddArray(valid);
    return image;
}

vtkSmartPointer<vtkPoints> pointsOf(const HeightRows& map, vtkDoubleArray* heights) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(heights->GetNumberOfTuples());
    vtkIdType id = 0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column, ++id) {
            points->SetPoint(id, (column + 0.5) * map.pitchX, (row + 0.5) * map.pitchY,
                             hasHeight(heights, id) ? heights->GetValue(id) : 0.0);
        }
    }
    return points;
}

/// Two triangles, counter-clockwise from above, for each four pixels that all have a height.
vtkSmartPointer<vtkPolyData> meshOf(const HeightRows& map, vtkDoubleArray* heights,
                                    const std::filesystem::path& path) {
    vtkNew<vtkCellArray> triangles;
    for (int row = 0; row + 1 < map.rows; ++row) {
        for (int column = 0; column + 1 < map.columns; ++column) {
            const vtkIdType corner = static_cast<vtkIdType>(row) * map.columns + column;
            const vtkIdType above = corner + map.columns;
            if (!hasHeight(heights, corner) || !hasHeight(heights, corner + 1) ||
                !hasHeight(heights, above) || !hasHeight(heights, above + 1)) {
                continue;
            }
            triangles->InsertNextCell({corner, corner + 1, above + 1});
            triangles->InsertNextCell({corner, above + 1, above});
        }
    }
    if (triangles->GetNumberOfCells() == 0) {
        throw Error(path.string() + ": the map has no 2 x 2 valid pixels to make a surface of");
    }
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(pointsOf(map, heights));
    mesh->SetPolys(triangles);
    mesh->GetPointData()->SetScalars(heights);
    return mesh;
}

/// Told by a VTK writer how far it is; stops it when the work is cancelled.
void passOn(vtkObject* writer, unsigned long /*event*/, void* progress, void* fraction) {
    auto* told = static_cast<Progress*>(progress);
    told->report(*static_cast<double*>(fraction));
    if (told->isCancelled()) {
        static_cast<vtkAlgorithm*>(writer)->SetAbortExecute(1);
    }
}

template <typename Writer>
void write(Writer* writer, vtkDataObject* data, const std::filesystem::path& path,
           Progress* progress) {
    const TemporaryFile file(path);
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(passOn);
    observer->SetClientData(progress);
    writer->AddObserver(vtkCommand::ProgressEvent, observer);
    writer->SetInputData(data);
    writer->SetFileName(file.path().c_str());
    const bool isWritten = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
    reportTo(progress, 1.0);
    if (!isWritten) {
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

bool canWriteHeightMapWithVtk(const std::filesystem::path& path) {
    const std::string extension = lowerCase(path.extension().string());
    return extension == ".vti" || extension == ".vtp" || extension == ".stl";
}

bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightRows& map,
                           Progress* progress) {
    if (!canWriteHeightMapWithVtk(path)) {
        return false;
    }
    const std::string extension = lowerCase(path.extension().string());
    ProgressPart filling(progress, 0.0, 0.3);
    const auto heights = heightArray(map, &filling);
    ProgressPart writing(progress, 0.3, 1.0);
    if (extension == ".vti") {
        const vtkNew<vtkXMLImageDataWriter> writer;
        write(writer.Get(), imageOf(map, heights), path, &writing);
    } else if (extension == ".vtp") {
        const vtkNew<vtkXMLPolyDataWriter> writer;
        write(writer.Get(), meshOf(map, heights, path), path, &writing);
    } else {
        const vtkNew<vtkSTLWriter> writer;
        writer->SetFileTypeToBinary();
        writer->SetHeader("Asperity height map; one unit is one metre");
        write(writer.Get(), meshOf(map, heights, path), path, &writing);
    }
    return true;
}

bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightMap& map) {
    return writeHeightMapWithVtk(path, rowsOf(map));
}

}  // namespace asperity
