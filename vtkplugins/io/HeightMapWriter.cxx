#include "vtkplugins/io/HeightMapWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "vtkplugins/io/HeightMesh.h"
#include "vtkplugins/io/StlWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace asperity {

namespace {

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

/// Told by a VTK writer how far it is. The writers of VTK 9.1 go on for minutes when AbortExecute
/// is set; an exception ends them, and they are not used again. @throw Canceled
void passOn(vtkObject* /*writer*/, unsigned long /*event*/, void* progress, void* fraction) {
    reportTo(static_cast<Progress*>(progress), *static_cast<double*>(fraction));
}

template <typename Writer>
void write(Writer* writer, vtkDataObject* data, const std::filesystem::path& target,
           Progress* progress) {
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(passOn);
    observer->SetClientData(progress);
    writer->AddObserver(vtkCommand::ProgressEvent, observer);
    writer->SetInputData(data);
    writer->SetFileName(target.c_str());
    const bool isWritten = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
    reportTo(progress, 1.0);
    requireWritten(isWritten);
}

void writeVti(const std::filesystem::path& target, const HeightRows& map, Progress* progress) {
    ProgressPart filling(progress, 0.0, 0.3);
    const auto image = imageOf(map, heightArray(map, &filling));
    ProgressPart writing(progress, 0.3, 1.0);
    write(vtkNew<vtkXMLImageDataWriter>().Get(), image, target, &writing);
}

void writeVtp(const std::filesystem::path& target, const HeightRows& map, Progress* progress) {
    ProgressPart filling(progress, 0.0, 0.1);
    const auto heights = heightArray(map, &filling);
    ProgressPart meshing(progress, 0.1, 0.3);
    const auto mesh = meshOf(map, heights, 0, &meshing);
    if (mesh->GetNumberOfPolys() == 0) {
        throw Error(kNoTriangles);
    }
    ProgressPart writing(progress, 0.3, 1.0);
    write(vtkNew<vtkXMLPolyDataWriter>().Get(), mesh, target, &writing);
}

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

using FileWriter = void (*)(const std::filesystem::path&, const HeightRows&, Progress*);

struct Format {
    const char* extension;
    FileWriter write;
};
constexpr std::array kFormats{Format{".vti", writeVti}, Format{".vtp", writeVtp},
                              Format{".stl", writeStl}};

/// Null when no format has the path's extension.
FileWriter writerFor(const std::filesystem::path& path) {
    const std::string extension = lowerCase(path.extension().string());
    for (const Format& format : kFormats) {
        if (extension == format.extension) {
            return format.write;
        }
    }
    return nullptr;
}

}  // namespace

std::vector<std::string> vtkExtensions() {
    std::vector<std::string> extensions;
    for (const Format& format : kFormats) {
        extensions.emplace_back(format.extension);
    }
    return extensions;
}

bool canWriteHeightMapWithVtk(const std::filesystem::path& path) {
    return writerFor(path) != nullptr;
}

bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightRows& map,
                           Progress* progress) {
    const FileWriter write = writerFor(path);
    if (write == nullptr) {
        return false;
    }
    const TemporaryFile file(path);
    try {
        write(file.path(), map, progress);
    } catch (const Error& error) {
        throw Error(path.string() + ": " + error.what());
    }
    file.commit();
    return true;
}

bool writeHeightMapWithVtk(const std::filesystem::path& path, const HeightMap& map) {
    return writeHeightMapWithVtk(path, rowsOf(map));
}

}  // namespace asperity
