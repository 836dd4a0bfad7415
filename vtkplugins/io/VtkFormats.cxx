#include "vtkplugins/io/VtkFormats.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <vtkByteSwap.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkSTLWriter.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLStructuredGridWriter.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

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

constexpr int kStripRows = 16;          // of squares between pixels
constexpr std::streamoff kHeader = 80;  // a text [bytes]; the number of triangles follows it

/// Rows of the map from one counted from below upwards; `map` must outlive them.
HeightRows stripOf(const HeightRows& map, int rowsBelow) {
    HeightRows strip = map;
    strip.rows = std::min(kStripRows + 1, map.rows - rowsBelow);
    const int top = map.rows - rowsBelow - strip.rows;
    strip.readRow = [&map, top](int row, double* heights) { map.readRow(top + row, heights); };
    return strip;
}

/// One STL file out of those of strips.
class JoinedStl {
public:
    explicit JoinedStl(const std::filesystem::path& target)
        : stream_(target, std::ios::binary), strip_(target) {
        writer_->SetFileTypeToBinary();
        writer_->SetHeader("Asperity height map; one unit is one meter");
        writer_->SetFileName(strip_.path().c_str());
    }

    void add(vtkPolyData* mesh) {
        writer_->SetInputData(mesh);
        requireWritten(writer_->Write() != 0 && writer_->GetErrorCode() == vtkErrorCode::NoError);
        std::ifstream strip(strip_.path(), std::ios::binary);
        if (triangles_ > 0) {
            strip.seekg(kHeader + static_cast<std::streamoff>(sizeof triangles_));
        }
        stream_ << strip.rdbuf();
        requireWritten(stream_.good());
        triangles_ += static_cast<std::uint32_t>(mesh->GetNumberOfPolys());
    }

    void close() {
        std::uint32_t count = triangles_;
        vtkByteSwap::Swap4LE(&count);
        stream_.seekp(kHeader);
        stream_.write(reinterpret_cast<const char*>(&count), sizeof count);
        stream_.close();
        requireWritten(stream_.good());
    }

    [[nodiscard]] bool isEmpty() const { return triangles_ == 0; }

private:
    std::ofstream stream_;
    TemporaryFile strip_;
    vtkNew<vtkSTLWriter> writer_;
    std::uint32_t triangles_ = 0;
};

/// Between a row and the one above it.
void addTriangles(vtkCellArray* triangles, vtkDoubleArray* heights, vtkIdType first, int columns) {
    const auto hasHeight = [&](vtkIdType point) {
        return isFiniteHeight(heights->GetValue(point));
    };
    for (vtkIdType corner = first; corner + 1 < first + columns; ++corner) {
        const vtkIdType above = corner + columns;
        if (hasHeight(corner) && hasHeight(corner + 1) && hasHeight(above) &&
            hasHeight(above + 1)) {
            triangles->InsertNextCell({corner, corner + 1, above + 1});
            triangles->InsertNextCell({corner, above + 1, above});
        }
    }
}

vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, const std::vector<Vector3>& vectors) {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        array->SetTuple(static_cast<vtkIdType>(i), vectors[i].data());
    }
    return array;
}

void setPoints(vtkPointSet* data, const SurfacePatch& patch) {
    std::vector<Vector3> displacements;
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        displacements.emplace_back(patch.points[i] - patch.rest[i]);
    }
    vtkNew<vtkPoints> points;
    points->SetData(arrayOf("points", patch.points));
    data->SetPoints(points);
    data->GetPointData()->AddArray(arrayOf("rest", patch.rest));
    data->GetPointData()->AddArray(arrayOf("displacement", displacements));
    data->GetPointData()->SetNormals(arrayOf("normal", patch.normals));
}

template <class Writer>
void write(const std::filesystem::path& path, vtkDataObject* data) {
    const TemporaryFile file(path);
    vtkNew<Writer> writer;
    writer->SetInputData(data);
    writer->SetFileName(file.path().c_str());
    if (writer->Write() == 0 || writer->GetErrorCode() != vtkErrorCode::NoError) {
        throw Error(path.string() + ": writing stopped half-way (disk full?)");
    }
    file.commit();
}

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

void writeStl(const std::filesystem::path& target, const HeightRows& map, Progress* progress) {
    JoinedStl joined(target);
    for (int rowsBelow = 0; rowsBelow + 1 < map.rows; rowsBelow += kStripRows) {
        const HeightRows strip = stripOf(map, rowsBelow);
        const auto heights = heightArray(strip, nullptr);
        const auto mesh = meshOf(strip, heights, rowsBelow, nullptr);
        if (mesh->GetNumberOfPolys() > 0) {
            joined.add(mesh);
        }
        reportTo(progress, static_cast<double>(rowsBelow + strip.rows) / map.rows);
    }
    if (joined.isEmpty()) {
        throw Error(kNoTriangles);
    }
    joined.close();
    reportTo(progress, 1.0);
}

void requireWritten(bool isWritten) {
    if (!isWritten) {
        throw Error("writing stopped half-way (disk full?)");
    }
}

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

vtkSmartPointer<vtkPoints> pointsOf(const HeightRows& map, vtkDoubleArray* heights, int rowsBelow) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(heights->GetNumberOfTuples());
    vtkIdType id = 0;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column, ++id) {
            const double height = heights->GetValue(id);
            points->SetPoint(id, (column + 0.5) * map.pitchX, (rowsBelow + row + 0.5) * map.pitchY,
                             isFiniteHeight(height) ? height : 0.0);
        }
    }
    return points;
}

vtkSmartPointer<vtkPolyData> meshOf(const HeightRows& map, vtkDoubleArray* heights, int rowsBelow,
                                    Progress* progress) {
    constexpr vtkIdType kIdsAPixel = 6;
    const vtkNew<vtkCellArray> triangles;
    if (kIdsAPixel * heights->GetNumberOfTuples() < std::numeric_limits<vtkTypeInt32>::max()) {
        triangles->Use32BitStorage();
    }
    triangles->AllocateExact(2 * heights->GetNumberOfTuples(),
                             kIdsAPixel * heights->GetNumberOfTuples());
    for (int row = 0; row + 1 < map.rows; ++row) {
        reportTo(progress, static_cast<double>(row) / map.rows);
        addTriangles(triangles, heights, static_cast<vtkIdType>(row) * map.columns, map.columns);
    }
    reportTo(progress, 1.0);
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(pointsOf(map, heights, rowsBelow));
    mesh->SetPolys(triangles);
    mesh->GetPointData()->SetScalars(heights);
    return mesh;
}

void writePatchVtp(const std::filesystem::path& path, const SurfacePatch& patch) {
    vtkNew<vtkPolyData> mesh;
    setPoints(mesh, patch);
    vtkNew<vtkCellArray> triangles;
    for (int row = 0; row + 1 < patch.rows; ++row) {
        for (int column = 0; column + 1 < patch.columns; ++column) {
            const auto a = static_cast<vtkIdType>(patch.index(row, column));
            const vtkIdType b = a + 1;
            const auto d = static_cast<vtkIdType>(patch.index(row + 1, column));
            const vtkIdType c = d + 1;
            triangles->InsertNextCell({a, b, c});
            triangles->InsertNextCell({a, c, d});
        }
    }
    mesh->SetPolys(triangles);
    write<vtkXMLPolyDataWriter>(path, mesh);
}

void writePatchVts(const std::filesystem::path& path, const SurfacePatch& patch) {
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(patch.columns, patch.rows, 1);
    setPoints(grid, patch);
    write<vtkXMLStructuredGridWriter>(path, grid);
}

}  // namespace asperity
