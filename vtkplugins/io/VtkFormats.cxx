#include "vtkplugins/io/VtkFormats.h"

#include "core/Error.h"
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

#include <array>
#include <string_view>

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

void writeVti(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    ProgressPart filling(progress, 0.0, 0.3);
    const auto values = heightArray(map, &filling);
    if (meta.unit.empty()) {
        values->SetName(meta.title.c_str());
    }
    const auto image = imageOf(map, values);
    ProgressPart writing(progress, 0.3, 1.0);
    write(vtkNew<vtkXMLImageDataWriter>().Get(), image, target, &writing);
}

void writeVtp(const std::filesystem::path& target, const HeightRows& map,
              const HeightMapMeta& /*meta*/, Progress* progress) {
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

constexpr std::array<std::string_view, 1> kVti{".vti"};
constexpr std::array<std::string_view, 1> kVtp{".vtp"};
constexpr std::array<std::string_view, 1> kStl{".stl"};

}  // namespace

const HeightMapFormat kVtiFormat = {
    .name = "VTK image .vti", .extensions = kVti, .write = writeVti};
const HeightMapFormat kVtpFormat = {
    .name = "VTK triangles .vtp", .extensions = kVtp, .write = writeVtp, .isShape = true};
const HeightMapFormat kStlFormat = {
    .name = "STL triangles .stl",
    .extensions = kStl,
    .write = [](const std::filesystem::path& target, const HeightRows& map,
                const HeightMapMeta& /*meta*/,
                Progress* progress) { writeStl(target, map, progress); },
    .isShape = true};

}  // namespace asperity
