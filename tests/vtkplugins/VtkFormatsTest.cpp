#include "vtkplugins/io/VtkFormats.h"

#include "core/Error.h"
#include "core/Units.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/vti/VtiWriter.h"
#include "tests/support/ProgressRecorder.h"

#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkStringArray.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLStructuredGridReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// All that VTK reads.
constexpr std::array kFormats{&kVtiFormat, kVtkFormats[0], kVtkFormats[1], kVtkFormats[2]};

/// A folder of its own for each test, removed afterwards.
class VtkFormats : public testing::Test {
protected:
    void SetUp() override {
        folder = std::filesystem::path(testing::TempDir()) /
                 ("asperity_writer_" +
                  std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string& name, const HeightMap& map, Progress* progress = nullptr) const {
        writeHeightMap(file(name), rowsOf(map), {}, progress, kFormats);
    }
    [[nodiscard]] std::filesystem::path file(const std::string& name) const {
        return folder / name;
    }

    std::filesystem::path folder;
};

/// 3 columns, 2 rows; heights in nm:  4 5 6  above  1 2 3.
HeightMap smallMap() {
    HeightMap map;
    map.columns = 3;
    map.rows = 2;
    map.pitchX = 10.0_nm;
    map.pitchY = 20.0_nm;
    map.heights = {4.0_nm, 5.0_nm, 6.0_nm, 1.0_nm, 2.0_nm, 3.0_nm};
    return map;
}

TEST_F(VtkFormats, ImageHoldsHeightsAtPixelCentersBottomRowFirst) {
    write("map.VTI", smallMap());
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file("map.VTI").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    EXPECT_EQ(image->GetDimensions()[0], 3);
    EXPECT_EQ(image->GetDimensions()[1], 2);
    EXPECT_DOUBLE_EQ(image->GetOrigin()[0], 5.0_nm);
    EXPECT_DOUBLE_EQ(image->GetOrigin()[1], 10.0_nm);
    EXPECT_DOUBLE_EQ(image->GetSpacing()[1], 20.0_nm);
    vtkDataArray* heights = image->GetPointData()->GetArray("height");
    ASSERT_NE(heights, nullptr);
    for (vtkIdType id = 0; id < 6; ++id) {
        EXPECT_DOUBLE_EQ(heights->GetTuple1(id), static_cast<double>(id + 1) * 1.0_nm);
    }
    EXPECT_EQ(image->GetPointData()->GetArray("valid"), nullptr);
}

TEST_F(VtkFormats, ImageMarksPixelsWithoutData) {
    HeightMap map = smallMap();
    map.invalid = {0, 1, 0, 0, 0, 0};
    map.heights[1] = std::numeric_limits<double>::quiet_NaN();
    write("map.vti", map);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file("map.vti").c_str());
    reader->Update();
    vtkDataArray* valid = reader->GetOutput()->GetPointData()->GetArray("valid");
    ASSERT_NE(valid, nullptr);
    for (vtkIdType id = 0; id < 6; ++id) {
        EXPECT_EQ(valid->GetTuple1(id), id == 4 ? 0.0 : 1.0);
    }
}

TEST_F(VtkFormats, ImagesOfOneGridAreArraysWithTheirUnits) {
    HeightMap holes = smallMap();
    holes.invalid = {0, 1, 0, 0, 0, 0};
    const HeightMap forces = smallMap();
    const std::vector<WrittenImage> images{{rowsOf(holes), {.title = "snap_in_distance"}},
                                           {rowsOf(forces), {.title = "force", .unit = "N"}}};
    writeVtiImages(file("map.vti"), images, nullptr);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file("map.vti").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    ASSERT_EQ(image->GetPointData()->GetNumberOfArrays(), 2);
    EXPECT_TRUE(std::isnan(image->GetPointData()->GetArray("snap_in_distance")->GetTuple1(4)));
    EXPECT_EQ(image->GetPointData()->GetArray("force")->GetTuple1(4), forces.heights[1]);
    EXPECT_NE(image->GetFieldData()->GetAbstractArray("unit of force"), nullptr);
}

TEST_F(VtkFormats, ImageOfNumbersWithoutAUnitHoldsNoHeights) {
    writeHeightMap(file("map.vti"), rowsOf(smallMap()), {.title = "Certainty", .unit = ""}, nullptr,
                   kFormats);
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file("map.vti").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("height"), nullptr);
    EXPECT_NE(reader->GetOutput()->GetPointData()->GetArray("Certainty"), nullptr);
    EXPECT_FALSE(kVtiFormat.isShape);
    EXPECT_TRUE(kVtpFormat.isShape && kStlFormat.isShape);
}

/// As VTK's own readers find them.
TEST_F(VtkFormats, ImageNamesTitleUnitAndOriginInItsFieldData) {
    writeHeightMap(file("map.vti"), rowsOf(smallMap()),
                   {.title = "Höhe <1> \"高さ\"", .originX = 1e-6, .originY = -2e-6}, nullptr,
                   kFormats);
    const vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(file("map.vti").c_str());
    reader->Update();
    vtkFieldData* data = reader->GetOutput()->GetFieldData();
    const auto text = [data](const char* name) {
        return std::string(
            vtkArrayDownCast<vtkStringArray>(data->GetAbstractArray(name))->GetValue(0));
    };
    EXPECT_EQ(text("title"), "Höhe <1> \"高さ\"");
    EXPECT_EQ(text("unit"), "m");
    EXPECT_EQ(data->GetArray("scan_origin")->GetTuple1(0), 1e-6);
    EXPECT_EQ(data->GetArray("scan_origin")->GetTuple1(1), -2e-6);
}

/// What ParaView saves as raw, appended and uncompressed.
TEST_F(VtkFormats, MeshRunsThroughThePixelCenters) {
    write("map.vtp", smallMap());
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file("map.vtp").c_str());
    reader->Update();
    vtkPolyData* mesh = reader->GetOutput();
    ASSERT_EQ(mesh->GetNumberOfPoints(), 6);
    EXPECT_EQ(mesh->GetNumberOfPolys(), 4);
    const double* point = mesh->GetPoint(5);  // top right
    EXPECT_DOUBLE_EQ(point[0], 25.0_nm);
    EXPECT_DOUBLE_EQ(point[1], 30.0_nm);
    EXPECT_DOUBLE_EQ(point[2], 6.0_nm);
}

TEST_F(VtkFormats, GridRunsThroughThePixelCentersAndHidesThoseWithoutData) {
    HeightMap map = smallMap();
    map.invalid = {0, 1, 0, 0, 0, 0};
    map.heights[1] = std::numeric_limits<double>::quiet_NaN();
    write("map.vts", map);
    const vtkNew<vtkXMLStructuredGridReader> reader;
    reader->SetFileName(file("map.vts").c_str());
    reader->Update();
    vtkStructuredGrid* grid = reader->GetOutput();
    EXPECT_EQ(grid->GetDimensions()[0], 3);
    EXPECT_EQ(grid->GetDimensions()[1], 2);
    const double* point = grid->GetPoint(5);  // top right
    EXPECT_DOUBLE_EQ(point[0], 25.0_nm);
    EXPECT_DOUBLE_EQ(point[1], 30.0_nm);
    EXPECT_DOUBLE_EQ(point[2], 6.0_nm);
    EXPECT_DOUBLE_EQ(grid->GetPointData()->GetArray("height")->GetTuple1(0), 1.0_nm);
    for (vtkIdType id = 0; id < 6; ++id) {
        EXPECT_EQ(grid->IsPointVisible(id) != 0, id != 4) << id;
    }
    EXPECT_TRUE(kVtsFormat.isShape);
}

TEST_F(VtkFormats, MeshLeavesOutTrianglesAtInvalidPixels) {
    HeightMap map = smallMap();
    map.invalid = {0, 0, 1, 0, 0, 0};
    write("map.vtp", map);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file("map.vtp").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 2);
}

TEST_F(VtkFormats, StlIsInMetersAndSaysSo) {
    write("map.stl", smallMap());
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName(file("map.stl").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 4);
    EXPECT_NEAR(reader->GetOutput()->GetBounds()[1], 25.0_nm, 1e-15);
    EXPECT_NEAR(reader->GetOutput()->GetBounds()[5], 6.0_nm, 1e-15);
    std::ifstream stream(file("map.stl"), std::ios::binary);
    std::string header(80, '\0');
    stream.read(header.data(), 80);
    EXPECT_NE(header.find("one unit is one meter"), std::string::npos);
}

/// An STL file of many rows is written in strips.
TEST_F(VtkFormats, StlHasTheTrianglesOfTheMesh) {
    HeightMap map = smallMap();
    map.rows = 50;
    map.heights.clear();
    for (int i = 0; i < 150; ++i) {
        const bool isMissing = i / 3 == 20 || i / 3 == 40;
        map.heights.push_back(isMissing ? std::numeric_limits<double>::quiet_NaN() : i * 1.0_nm);
    }
    write("map.stl", map);
    write("map.vtp", map);
    const vtkNew<vtkSTLReader> stl;
    stl->MergingOff();
    stl->SetFileName(file("map.stl").c_str());
    stl->Update();
    const vtkNew<vtkXMLPolyDataReader> vtp;
    vtp->SetFileName(file("map.vtp").c_str());
    vtp->Update();
    constexpr vtkIdType kTriangles = 2 * 2 * 45;
    ASSERT_EQ(vtp->GetOutput()->GetNumberOfCells(), kTriangles);
    ASSERT_EQ(stl->GetOutput()->GetNumberOfCells(), kTriangles);
    EXPECT_EQ(std::filesystem::file_size(file("map.stl")), 84U + 50U * kTriangles);
    for (vtkIdType cell = 0; cell < kTriangles; ++cell) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto position = [&](vtkPolyData* mesh) {
                return mesh->GetPoint(mesh->GetCell(cell)->GetPointId(corner));
            };
            std::array<double, 3> expected{};
            std::ranges::copy_n(position(vtp->GetOutput()), 3, expected.begin());
            const double* written = position(stl->GetOutput());
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(written[axis], static_cast<float>(expected.at(axis)));
            }
        }
    }
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
}

TEST_F(VtkFormats, OtherExtensionsAreNotOurs) {
    EXPECT_THROW(write("map.gsf", smallMap()), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(VtkFormats, TellsHowFarItIsAndLeavesNothingBehindWhenCanceled) {
    HeightMap map = smallMap();
    map.rows = 200;
    map.heights.assign(600, 1.0_nm);
    for (const std::string name : {"map.vti", "map.vtp", "map.vts", "map.stl"}) {
        for (const double fraction : {0.0, 0.2, 0.3, 0.5, 1.0}) {
            test::ProgressRecorder recorder(fraction);
            EXPECT_THROW(write(name, map, &recorder), Canceled);
            // VTK writes so small a grid in one go.
            const bool isOneGo = name == "map.vts" && fraction == 0.5;
            EXPECT_TRUE(fraction == 1.0 || isOneGo || recorder.fractions.back() < 1.0)
                << name << fraction;
            EXPECT_TRUE(std::filesystem::is_empty(folder)) << name << fraction;
        }
    }
    for (const std::string name : {"map.vti", "map.vtp", "map.vts", "map.stl"}) {
        test::ProgressRecorder recorder(2.0);
        write(name, map, &recorder);
        EXPECT_TRUE(std::ranges::is_sorted(recorder.fractions)) << name;
        EXPECT_EQ(recorder.fractions.back(), 1.0);
    }
}

TEST_F(VtkFormats, FailuresThrowAndLeaveNothingBehind) {
    HeightMap blind = smallMap();
    blind.invalid.assign(6, 1);
    EXPECT_THROW(write("map.stl", blind), Error);
    HeightMap broken = smallMap();
    broken.heights.pop_back();
    EXPECT_THROW(write("map.vti", broken), Error);
    EXPECT_THROW(write("missing/map.vti", smallMap()), Error);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace
}  // namespace asperity
