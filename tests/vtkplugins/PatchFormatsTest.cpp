#include "core/Error.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/ScratchFolder.h"
#include "vtkplugins/io/VtkFormats.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLStructuredGridReader.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace asperity {
namespace {

/// 4 x 3 points of no round numbers.
SurfacePatch bumpyPatch() {
    SurfacePatch patch{.columns = 4, .rows = 3, .rest = {}, .points = {}, .normals = {}};
    for (int row = 0; row < patch.rows; ++row) {
        for (int column = 0; column < patch.columns; ++column) {
            const Vector3 rest(1e-9 / 3.0 * column, 1e-9 / 7.0 * row, 1e-10 / 9.0 * row * column);
            patch.rest.push_back(rest);
            patch.points.emplace_back(rest + Vector3(1e-12 / 3.0, -1e-12 / 11.0 * row, -2e-10));
            patch.normals.push_back(Vector3(0.1 * row, 0.2 * column, 1.0).normalized());
        }
    }
    return patch;
}

void expectSamePoints(vtkPointSet* read, const SurfacePatch& patch) {
    ASSERT_EQ(read->GetNumberOfPoints(), 12);
    const auto vector = [read](const char* name, std::size_t i) {
        return Vector3(read->GetPointData()->GetArray(name)->GetTuple3(static_cast<vtkIdType>(i)));
    };
    for (std::size_t i = 0; i < patch.points.size(); ++i) {
        EXPECT_EQ(Vector3(read->GetPoint(static_cast<vtkIdType>(i))), patch.points[i]);
        EXPECT_EQ(vector("rest", i), patch.rest[i]);
        EXPECT_EQ(vector("displacement", i), patch.points[i] - patch.rest[i]);
        EXPECT_EQ(vector("normal", i), patch.normals[i]);
    }
}

TEST(PatchFormats, TrianglesReadBackToTheBit) {
    const test::ScratchFolder folder;
    const auto path = folder.path() / "a.vtp";
    writePatchVtp(path, bumpyPatch());
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    expectSamePoints(reader->GetOutput(), bumpyPatch());
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 12);
}

TEST(PatchFormats, GridReadsBackToTheBit) {
    const test::ScratchFolder folder;
    const auto path = folder.path() / "a.vts";
    writePatchVts(path, bumpyPatch());
    vtkNew<vtkXMLStructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    expectSamePoints(reader->GetOutput(), bumpyPatch());
    int size[3];
    reader->GetOutput()->GetDimensions(size);
    EXPECT_EQ(size[0], 4);
    EXPECT_EQ(size[1], 3);
}

TEST(PatchFormats, LeaveNothingOnAFullDisk) {
    const test::ScratchFolder folder;
    const test::FileSizeLimit limit(100);
    EXPECT_THROW(writePatchVtp(folder.path() / "a.vtp", bumpyPatch()), Error);
    EXPECT_THROW(writePatchVts(folder.path() / "a.vts", bumpyPatch()), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace asperity
