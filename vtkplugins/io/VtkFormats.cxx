#include "vtkplugins/io/VtkFormats.h"

#include "core/Error.h"
#include "vtkplugins/io/HeightMesh.h"
#include "vtkplugins/io/StlWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLStructuredGridWriter.h>

#include <array>
#include <string_view>

namespace asperity {

namespace {

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

/// Points without data are blanked, so that no surface is shown there.
void writeVts(const std::filesystem::path& target, const HeightRows& map,
              const HeightMapMeta& /*meta*/, Progress* progress) {
    ProgressPart filling(progress, 0.0, 0.3);
    const auto heights = heightArray(map, &filling);
    const vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(map.columns, map.rows, 1);
    grid->SetPoints(pointsOf(map, heights, 0));
    grid->GetPointData()->SetScalars(heights);
    for (vtkIdType point = 0; point < heights->GetNumberOfTuples(); ++point) {
        if (!isFiniteHeight(heights->GetValue(point))) {
            grid->BlankPoint(point);
        }
    }
    ProgressPart writing(progress, 0.3, 1.0);
    write(vtkNew<vtkXMLStructuredGridWriter>().Get(), grid.Get(), target, &writing);
}

constexpr std::array<std::string_view, 1> kVtp{".vtp"};
constexpr std::array<std::string_view, 1> kVts{".vts"};
constexpr std::array<std::string_view, 1> kStl{".stl"};

}  // namespace

const HeightMapFormat kVtpFormat = {
    .name = "VTK triangles .vtp", .extensions = kVtp, .write = writeVtp, .isShape = true};
const HeightMapFormat kVtsFormat = {
    .name = "VTK structured grid .vts", .extensions = kVts, .write = writeVts, .isShape = true};
const HeightMapFormat kStlFormat = {
    .name = "STL triangles .stl",
    .extensions = kStl,
    .write = [](const std::filesystem::path& target, const HeightRows& map,
                const HeightMapMeta& /*meta*/,
                Progress* progress) { writeStl(target, map, progress); },
    .isShape = true};

}  // namespace asperity
